// Who gets primitives in place of set-up: selection and feedback look at them as they leave clipping, culling
// and the polygon modes (GL 1.5 §5.2, §5.3).
#pragma once

#include "pipeline/geometry/shaded_vertices.h"

namespace terrazzo::pipeline {

class PrimitiveObserver {
  public:
    virtual void point(const ShadedVertices& vertices, int v) = 0;
    // `restarts`: a line stipple would begin anew with this line.
    virtual void line(const ShadedVertices& vertices, int a, int b, bool restarts) = 0;
    // Filled, and with the colours of the side that shows; the last vertex is the provoking one.
    virtual void triangle(const ShadedVertices& vertices, int a, int b, int c) = 0;

  protected:
    ~PrimitiveObserver() = default;
};

}  // namespace terrazzo::pipeline
