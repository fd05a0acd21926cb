// A set of object names kept as ranges, so that setting aside two thousand million names costs one entry.
//
// 0 is never a name. Invariant: ranges do not overlap or touch.
#pragma once

#include <GL/gl.h>

#include <map>

namespace terrazzo::gl {

class NameRanges {
  public:
    bool contains(GLuint name) const;

    // All that change the set throw std::bad_alloc and change nothing then.

    // Adds first to last, both included; names in use already stay.
    void insert(GLuint first, GLuint last);

    // Takes first to last out, both included.
    void erase(GLuint first, GLuint last);

    // Adds the lowest `count` consecutive names that are free and returns the first; 0 when there are none.
    GLuint take(GLuint count);

  private:
    std::map<GLuint, GLuint> m_last_of;  // first name of a range -> its last
};

}  // namespace terrazzo::gl
