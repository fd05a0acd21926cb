// The list of good calls; see valid_calls.h. The tests' context has a 4x4 RGBA texture bound to GL_TEXTURE_2D
// one
// of 4 texels bound to GL_TEXTURE_1D and one of 4x4x4 to GL_TEXTURE_3D.
#include "valid_calls.h"

#include <map>
#include <regex>

namespace terrazzo::test {

const std::vector<ValidCall>& valid_calls() {
    constexpr Buffer in;
    constexpr Scratch out;
    static const std::vector<ValidCall> calls = {
        {"gl(Client)?ActiveTexture(ARB)?", {GL_TEXTURE3}},
        {"glAlphaFunc", {GL_LESS, 0.5}},
        {"glAreTexturesResident(EXT)?", {1, Names{}, out}},
        {"glBegin", {GL_TRIANGLES}},
        {"glBindTexture(EXT)?", {GL_TEXTURE_2D, 1}},
        {"glBlendEquation(EXT)?", {GL_MIN}},
        {"glBlendEquationSeparate(EXT|ATI)?", {GL_MIN, GL_MAX}},
        {"glBlendFunc", {GL_ONE, GL_ONE}},
        {"glBlendFuncSeparate(EXT|INGR)?", {GL_ONE, GL_ZERO, GL_ZERO, GL_ONE}},
        {"glBeginQuery(ARB)?", {GL_SAMPLES_PASSED, 1}},
        {"glBindBuffer(ARB)?", {GL_ARRAY_BUFFER, 0}},
        {"glBufferData(ARB)?", {GL_ARRAY_BUFFER, 8, in, GL_STREAM_DRAW}},
        {"glBufferSubData(ARB)?", {GL_ARRAY_BUFFER, 8, 8, in}},
        {"glCallLists", {1, GL_UNSIGNED_BYTE, in}},
        {"glClipPlane", {GL_CLIP_PLANE0, in}},
        {"gl(Color[34]|Normal3|TexCoord[1234]|Vertex[234])(b|d|f|i|s|ub|ui|us)v", {in}},
        {"gl(EdgeFlag|Indexd|Indexf|Indexi|Indexs|Indexub)v", {in}},
        {"glColorMaterial", {GL_FRONT, GL_DIFFUSE}},
        {"gl(Color|Vertex|TexCoord)Pointer", {4, GL_FLOAT, 0, in}},
        {"gl(Color|Vertex|TexCoord)PointerEXT", {4, GL_FLOAT, 0, 1, in}},
        {"gl(Normal|Index)Pointer", {GL_FLOAT, 0, in}},
        {"gl(Normal|Index)PointerEXT", {GL_FLOAT, 0, 1, in}},
        {"glSecondaryColorPointer(EXT)?", {3, GL_FLOAT, 0, in}},
        {"glFogCoordPointer(EXT)?", {GL_FLOAT, 0, in}},
        {"glSecondaryColor3(b|d|f|i|s|ub|ui|us)v(EXT)?", {in}},
        {"glFogCoord[df]v(EXT)?", {in}},
        {"glMultiTexCoord1[dfis](ARB)?", {GL_TEXTURE1, 1.0}},
        {"glMultiTexCoord2[dfis](ARB)?", {GL_TEXTURE1, 1.0, 1.0}},
        {"glMultiTexCoord3[dfis](ARB)?", {GL_TEXTURE1, 1.0, 1.0, 1.0}},
        {"glMultiTexCoord4[dfis](ARB)?", {GL_TEXTURE1, 1.0, 1.0, 1.0, 1.0}},
        {"glMultiTexCoord[1234][dfis]v(ARB)?", {GL_TEXTURE1, in}},
        {"glEdgeFlagPointer", {0, in}},
        {"glEdgeFlagPointerEXT", {0, 1, in}},
        {"glCompressedTexImage2D(ARB)?",
         {GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, 0, 16, in}},
        {"glCompressedTexSubImage2D(ARB)?",
         {GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, in}},
        {"glGetCompressedTexImage(ARB)?", {GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, out}},
        {"glCopyTexImage1D(EXT)?", {GL_TEXTURE_1D, 0, GL_RGBA, 0, 0, 4, 0}},
        {"glCopyTexImage2D(EXT)?", {GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 4, 4, 0}},
        {"glCopyTexSubImage1D(EXT)?", {GL_TEXTURE_1D, 0, 0, 0, 0, 2}},
        {"glCopyTexSubImage2D(EXT)?", {GL_TEXTURE_2D, 0, 0, 0, 0, 0, 2, 2}},
        {"glCopyTexSubImage3D(EXT)?", {GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, 2, 2}},
        {"glCullFace", {GL_FRONT}},
        {"glDeleteBuffers(ARB)?", {1, in}},
        {"glDeleteLists", {1, 1}},
        {"glDeleteTextures(EXT)?", {1, in}},
        {"glDeleteQueries(ARB)?", {1, in}},
        {"glDepthFunc", {GL_ALWAYS}},
        {"gl(En|Dis)able", {GL_FOG}},
        {"gl(En|Dis)ableClientState", {GL_VERTEX_ARRAY}},
        {"glDrawArrays(EXT)?", {GL_TRIANGLES, 0, 3}},
        {"glDrawBuffer", {GL_FRONT}},
        {"glDrawElements", {GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, in}},
        {"glDrawRangeElements(EXT)?", {GL_TRIANGLES, 0, 0, 3, GL_UNSIGNED_SHORT, in}},
        {"glEndQuery(ARB)?", {GL_SAMPLES_PASSED}},
        {"glFog[fi]", {GL_FOG_DENSITY, 1.0}},
        {"glFog[fi]v", {GL_FOG_START, in}},
        {"glFrontFace", {GL_CW}},
        {"glGenBuffers(ARB)?", {1, out}},
        {"glGenerateMipmap(EXT)?", {GL_TEXTURE_2D}},
        {"glGenLists", {1}},
        {"glGenQueries(ARB)?", {1, out}},
        {"glGenTextures(EXT)?", {1, out}},
        {"glGet(Boolean|Double|Float|Integer)v", {GL_FOG_START, out}},
        {"glGetBufferParameteriv(ARB)?", {GL_ARRAY_BUFFER, GL_BUFFER_SIZE, out}},
        {"glGetBufferPointerv(ARB)?", {GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, out}},
        {"glGetBufferSubData(ARB)?", {GL_ARRAY_BUFFER, 8, 8, out}},
        {"glGetClipPlane", {GL_CLIP_PLANE0, out}},
        {"glGetLight[fi]v", {GL_LIGHT0, GL_DIFFUSE, out}},
        {"glGetMaterial[fi]v", {GL_FRONT, GL_DIFFUSE, out}},
        {"glGetPixelMap(f|ui|us)v", {GL_PIXEL_MAP_I_TO_R, out}},
        {"glGetPointerv(EXT|KHR)?", {GL_VERTEX_ARRAY_POINTER, out}},
        {"glGetPolygonStipple", {out}},
        {"glGetQueryiv(ARB)?", {GL_SAMPLES_PASSED, GL_CURRENT_QUERY, out}},
        {"glGetQueryObjectu?iv(ARB|EXT)?", {1, GL_QUERY_RESULT, out}},
        {"glGetString", {GL_VENDOR}},
        {"glGetTexEnv[fi]v", {GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, out}},
        {"glGetTexGen[dfi]v", {GL_S, GL_EYE_PLANE, out}},
        {"glGetTexImage", {GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, out}},
        {"glGetTexLevelParameter[fi]v", {GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, out}},
        {"glGetTexParameter[fi]v", {GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, out}},
        {"glHint", {GL_FOG_HINT, GL_NICEST}},
        {"glInterleavedArrays", {GL_V3F, 0, in}},
        {"glIsEnabled", {GL_FOG}},
        {"glLight[fi]", {GL_LIGHT0, GL_LINEAR_ATTENUATION, 1.0}},
        {"glLight[fi]v", {GL_LIGHT0, GL_DIFFUSE, in}},
        {"glLightModel[fi]", {GL_LIGHT_MODEL_TWO_SIDE, 1.0}},
        {"glLightModel[fi]v", {GL_LIGHT_MODEL_AMBIENT, in}},
        {"gl(Load|Mult)(Transpose)?Matrix[df](ARB)?", {in}},
        {"glLogicOp", {GL_XOR}},
        {"glMapBuffer(ARB)?", {GL_ARRAY_BUFFER, GL_READ_WRITE}},
        {"glMaterial[fi]", {GL_FRONT, GL_SHININESS, 1.0}},
        {"glMaterial[fi]v", {GL_FRONT, GL_DIFFUSE, in}},
        {"glMatrixMode", {GL_TEXTURE}},
        {"glMultiDrawArrays(EXT)?", {GL_TRIANGLES, in, in, 1}},
        {"glMultiDrawElements(EXT)?", {GL_TRIANGLES, Names{}, GL_UNSIGNED_INT, in, 1}},
        {"glNewList", {1, GL_COMPILE}},
        {"glPixelMap(f|ui|us)v", {GL_PIXEL_MAP_R_TO_R, 2, in}},
        {"glPixelStore[fi]", {GL_PACK_ALIGNMENT, 1.0}},
        {"glPixelTransfer[fi]", {GL_RED_SCALE, 1.0}},
        {"glPointParameter[fi](ARB|EXT|NV|SGIS)?", {GL_POINT_SIZE_MAX, 4.0}},
        {"glPointParameter[fi]v(ARB|EXT|NV|SGIS)?", {GL_POINT_DISTANCE_ATTENUATION, in}},
        {"glPolygonMode", {GL_FRONT, GL_LINE}},
        {"glPolygonStipple", {in}},
        {"glPrioritizeTextures(EXT)?", {1, in, in}},
        {"glCopyPixels", {0, 0, 2, 2, GL_COLOR}},
        {"glDrawPixels", {2, 2, GL_RGBA, GL_FLOAT, in}},
        {"glBitmap", {2, 2, 0.0, 0.0, 1.0, 1.0, in}},
        {"glEvalCoord[12][df]v", {in}},
        {"glEvalMesh1", {GL_LINE, 0, 1}},
        {"glEvalMesh2", {GL_LINE, 0, 1, 0, 1}},
        {"glGetMap[dfi]v", {GL_MAP1_COLOR_4, GL_ORDER, out}},
        {"glMap1[df]", {GL_MAP1_COLOR_4, 0.0, 1.0, 4, 2, in}},
        {"glMap2[df]", {GL_MAP2_COLOR_4, 0.0, 1.0, 4, 2, 0.0, 1.0, 8, 2, in}},
        {"glAccum", {GL_MULT, 0.5}},
        {"glFeedbackBuffer", {8, GL_3D, out}},
        {"glRenderMode", {GL_RENDER}},
        {"glSelectBuffer", {8, out}},
        {"glRasterPos[234][dfis]v", {in}},
        {"glReadBuffer", {GL_FRONT}},
        {"glReadPixels", {0, 0, 2, 2, GL_RGBA, GL_FLOAT, out}},
        {"glRect[dfis]v", {in, in}},
        {"glScissor", {0, 0, 1, 1}},
        {"glShadeModel", {GL_FLAT}},
        {"glStencilFunc", {GL_LESS, 1, 1}},
        {"glStencilOp", {GL_INCR, GL_DECR, GL_ZERO}},
        {"glTexEnv[fi]", {GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, 8448.0}},  // GL_MODULATE
        {"glTexEnv[fi]v", {GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, in}},
        {"glTexGen[dfi]", {GL_S, GL_TEXTURE_GEN_MODE, 9217.0}},  // GL_OBJECT_LINEAR
        {"glTexGen[dfi]v", {GL_S, GL_EYE_PLANE, in}},
        {"glTexImage1D", {GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_FLOAT, in}},
        {"glTexImage2D", {GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_FLOAT, in}},
        {"glTexImage3D(EXT)?", {GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_FLOAT, in}},
        {"glTexParameter[fi]", {GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, 9728.0}},  // GL_NEAREST
        {"glTexParameter[fi]v", {GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, in}},
        {"glTexSubImage1D(EXT)?", {GL_TEXTURE_1D, 0, 0, 2, GL_RGBA, GL_FLOAT, in}},
        {"glTexSubImage2D(EXT)?", {GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_RGBA, GL_FLOAT, in}},
        {"glTexSubImage3D(EXT)?", {GL_TEXTURE_3D, 0, 0, 0, 0, 2, 2, 2, GL_RGBA, GL_FLOAT, in}},
        {"glUnmapBuffer(ARB)?", {GL_ARRAY_BUFFER}},
        {"glViewport", {0, 0, 1, 1}},
        {"glWindowPos[23][dfis]v(ARB|MESA)?", {in}},
    };
    return calls;
}

const std::vector<Argument>* valid_arguments(const std::string& name) {
    static const auto by_name = [] {
        std::map<std::string, const std::vector<Argument>*> found;
        for (const ValidCall& valid : valid_calls()) {
            const std::regex names(valid.names);
            for (const gl::Call& call : gl::kEveryCall) {
                if (std::regex_match(call.name, names)) found[call.name] = &valid.arguments;
            }
        }
        return found;
    }();
    const auto found = by_name.find(name);
    return found == by_name.end() ? nullptr : found->second;
}

}  // namespace terrazzo::test
