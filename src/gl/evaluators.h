// Evaluators (GL 1.5 §5.1, table 6.30): Bezier maps of one and two variables, and the grids that EvalMesh
// walks.
#pragma once

#include <GL/gl.h>

#include <array>
#include <vector>

namespace terrazzo::gl {

// The maps of one kind in the order of the enumerants from GL_MAP1_COLOR_4 and GL_MAP2_COLOR_4 on.
enum EvaluatorTarget : int {
    kMapColor4,
    kMapIndex,
    kMapNormal,
    kMapTexture1,
    kMapTexture2,
    kMapTexture3,
    kMapTexture4,
    kMapVertex3,
    kMapVertex4,
    kEvaluatorTargetCount
};

// Parameters are scaled from [u1, u2] (and [v1, v2]) to [0, 1].
struct EvaluatorMap {
    std::array<GLfloat, 4> domain{0, 1, 0, 1};
    std::array<GLint, 2> order{1, 1};
    std::vector<GLfloat> points;  // order[1] after one another for each of order[0]
};

using EvaluatorMaps = std::array<EvaluatorMap, kEvaluatorTargetCount>;
using EvaluatorEnables = std::array<bool, kEvaluatorTargetCount>;

struct EvaluatorGrid {
    GLint segments = 1;
    GLfloat first = 0, last = 1;

    GLfloat step() const { return (last - first) / static_cast<GLfloat>(segments); }
};

// The part that glPushAttrib(GL_EVAL_BIT) saves.
struct EvaluatorModes {
    EvaluatorEnables enabled_1d{}, enabled_2d{};
    bool auto_normal = false;
    EvaluatorGrid grid_1d;
    std::array<EvaluatorGrid, 2> grid_2d;
};

struct EvaluatorState {
    EvaluatorState();

    EvaluatorModes modes;
    EvaluatorMaps maps_1d, maps_2d;
};

// The flag behind a capability of one of the maps; null for others.
bool* find_evaluator_flag(EvaluatorModes& modes, GLenum cap);

// Elements behind the pointer of Map1 and Map2; 0 when an argument is wrong.
std::ptrdiff_t map_elements(GLenum target, GLint stride, GLint order);
std::ptrdiff_t map_elements(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder);

}  // namespace terrazzo::gl
