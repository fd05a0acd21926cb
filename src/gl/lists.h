// Display lists (GL 1.5 §5.4): the list being compiled, and where calls of lists stand.
//
// Finished lists live in ShareGroup. Commands reach the list through kCompilingTable (gl/current.h), whose
// generated functions append records (gl/list_record.h); CallList plays them through DispatchState::execute.
#pragma once

#include <GL/gl.h>

#include <cstddef>
#include <memory>

#include "gl/list_vertices.h"

namespace terrazzo::gl {

class DisplayList;

struct ListState {
    std::shared_ptr<DisplayList> compiling;  // null outside NewList and EndList
    GLuint compiling_name = 0;
    GLenum mode = 0;             // of NewList; 0 outside
    bool execute_too = false;    // GL_COMPILE_AND_EXECUTE
    bool out_of_memory = false;  // the list being compiled could not take a record and will not be kept
    ListVertices vertices;       // of the list being compiled
    GLuint base = 0;
    int nesting = 0;  // calls of lists in progress
};

// Size of what glCallLists reads; 0 when an argument is wrong.
std::size_t call_lists_bytes(GLsizei n, GLenum type);

}  // namespace terrazzo::gl
