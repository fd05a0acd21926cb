// Reads every state variable in every type that a query offers; see state_dump.h.
#include "state_dump.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <iterator>

namespace terrazzo::test {
namespace {

struct Name {
    GLenum value;
    const char* text;
};

#define TERRAZZO_NAME(name) \
    { name, #name }

// Variables of glGet and how many values they have.
struct Variable {
    Name name;
    int count;
    bool integers = true;  // whether GetIntegerv is compared
};

// Integers are not compared where the state is floating-point: GL 1.5 §6.1.2 rounds to the nearest, while the
// reference truncates the parameters of objects, scales matrices as if they were colours, and wraps round
// what does not fit. The conversions have their own tests (tests/unit/get_test.cpp).
// GL_TRANSPOSE_TEXTURE_MATRIX is left out: the reference answers it for unit 0, whatever unit is active.
constexpr Variable kVariables[] = {
    {TERRAZZO_NAME(GL_MODELVIEW_MATRIX), 16, false},
    {TERRAZZO_NAME(GL_PROJECTION_MATRIX), 16, false},
    {TERRAZZO_NAME(GL_TEXTURE_MATRIX), 16, false},
    {TERRAZZO_NAME(GL_MODELVIEW_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_PROJECTION_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_TEXTURE_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MATRIX_MODE), 1},
    {TERRAZZO_NAME(GL_CLIP_ORIGIN), 1},
    {TERRAZZO_NAME(GL_CLIP_DEPTH_MODE), 1},
    {TERRAZZO_NAME(GL_VIEWPORT), 4},
    {TERRAZZO_NAME(GL_DEPTH_RANGE), 2, false},
    {TERRAZZO_NAME(GL_FOG_MODE), 1},
    {TERRAZZO_NAME(GL_FOG_COLOR), 4, false},
    {TERRAZZO_NAME(GL_FOG_DENSITY), 1, false},
    {TERRAZZO_NAME(GL_FOG_START), 1, false},
    {TERRAZZO_NAME(GL_FOG_END), 1, false},
    {TERRAZZO_NAME(GL_FOG_INDEX), 1, false},
    {TERRAZZO_NAME(GL_FOG_COORDINATE_SOURCE), 1},
    {TERRAZZO_NAME(GL_FOG_DISTANCE_MODE_NV), 1},
    {TERRAZZO_NAME(GL_SHADE_MODEL), 1},
    {TERRAZZO_NAME(GL_COLOR_MATERIAL_FACE), 1},
    {TERRAZZO_NAME(GL_COLOR_MATERIAL_PARAMETER), 1},
    {TERRAZZO_NAME(GL_LIGHT_MODEL_AMBIENT), 4, false},
    {TERRAZZO_NAME(GL_LIGHT_MODEL_LOCAL_VIEWER), 1},
    {TERRAZZO_NAME(GL_LIGHT_MODEL_TWO_SIDE), 1},
    {TERRAZZO_NAME(GL_LIGHT_MODEL_COLOR_CONTROL), 1},
    {TERRAZZO_NAME(GL_POINT_SIZE), 1, false},
    {TERRAZZO_NAME(GL_SAMPLE_BUFFERS), 1},
    {TERRAZZO_NAME(GL_SAMPLES), 1},
    {TERRAZZO_NAME(GL_SAMPLE_COVERAGE_VALUE), 1, false},
    {TERRAZZO_NAME(GL_SAMPLE_COVERAGE_INVERT), 1},
    {TERRAZZO_NAME(GL_POINT_SIZE_MIN), 1, false},
    {TERRAZZO_NAME(GL_POINT_SIZE_MAX), 1, false},
    {TERRAZZO_NAME(GL_POINT_FADE_THRESHOLD_SIZE), 1, false},
    {TERRAZZO_NAME(GL_POINT_DISTANCE_ATTENUATION), 3, false},
    {TERRAZZO_NAME(GL_MAX_TEXTURE_LOD_BIAS), 1, false},
    {TERRAZZO_NAME(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT), 1, false},
    {TERRAZZO_NAME(GL_LINE_WIDTH), 1, false},
    {TERRAZZO_NAME(GL_LINE_STIPPLE_PATTERN), 1},
    {TERRAZZO_NAME(GL_LINE_STIPPLE_REPEAT), 1},
    {TERRAZZO_NAME(GL_CULL_FACE_MODE), 1},
    {TERRAZZO_NAME(GL_FRONT_FACE), 1},
    {TERRAZZO_NAME(GL_POLYGON_MODE), 2},
    {TERRAZZO_NAME(GL_POLYGON_OFFSET_FACTOR), 1, false},
    {TERRAZZO_NAME(GL_POLYGON_OFFSET_UNITS), 1, false},
    {TERRAZZO_NAME(GL_MAX_TEXTURE_UNITS), 1},
    {TERRAZZO_NAME(GL_ACTIVE_TEXTURE), 1},
    {TERRAZZO_NAME(GL_CLIENT_ACTIVE_TEXTURE), 1},
    {TERRAZZO_NAME(GL_TEXTURE_BINDING_1D), 1},
    {TERRAZZO_NAME(GL_TEXTURE_BINDING_2D), 1},
    {TERRAZZO_NAME(GL_TEXTURE_BINDING_3D), 1},
    {TERRAZZO_NAME(GL_TEXTURE_BINDING_CUBE_MAP), 1},
    {TERRAZZO_NAME(GL_MAX_3D_TEXTURE_SIZE), 1},
    {TERRAZZO_NAME(GL_MAX_CUBE_MAP_TEXTURE_SIZE), 1},
    {TERRAZZO_NAME(GL_SCISSOR_BOX), 4},
    {TERRAZZO_NAME(GL_ALPHA_TEST_FUNC), 1},
    {TERRAZZO_NAME(GL_ALPHA_TEST_REF), 1, false},
    {TERRAZZO_NAME(GL_STENCIL_FUNC), 1},
    {TERRAZZO_NAME(GL_STENCIL_VALUE_MASK), 1},
    {TERRAZZO_NAME(GL_STENCIL_REF), 1},
    {TERRAZZO_NAME(GL_STENCIL_FAIL), 1},
    {TERRAZZO_NAME(GL_STENCIL_PASS_DEPTH_FAIL), 1},
    {TERRAZZO_NAME(GL_STENCIL_PASS_DEPTH_PASS), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_FUNC), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_VALUE_MASK), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_REF), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_FAIL), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_PASS_DEPTH_FAIL), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_PASS_DEPTH_PASS), 1},
    {TERRAZZO_NAME(GL_STENCIL_BACK_WRITEMASK), 1},
    {TERRAZZO_NAME(GL_STENCIL_TEST_TWO_SIDE_EXT), 1},
    {TERRAZZO_NAME(GL_ACTIVE_STENCIL_FACE_EXT), 1},
    {TERRAZZO_NAME(GL_ARRAY_ELEMENT_LOCK_FIRST_EXT), 1},
    {TERRAZZO_NAME(GL_ARRAY_ELEMENT_LOCK_COUNT_EXT), 1},
    {TERRAZZO_NAME(GL_DEPTH_FUNC), 1},
    {TERRAZZO_NAME(GL_BLEND_SRC), 1},
    {TERRAZZO_NAME(GL_BLEND_DST), 1},
    {TERRAZZO_NAME(GL_LOGIC_OP_MODE), 1},
    {TERRAZZO_NAME(GL_DRAW_BUFFER), 1},
    {TERRAZZO_NAME(GL_READ_BUFFER), 1},
    {TERRAZZO_NAME(GL_INDEX_WRITEMASK), 1},
    {TERRAZZO_NAME(GL_COLOR_WRITEMASK), 4},
    {TERRAZZO_NAME(GL_DEPTH_WRITEMASK), 1},
    {TERRAZZO_NAME(GL_STENCIL_WRITEMASK), 1},
    {TERRAZZO_NAME(GL_COLOR_CLEAR_VALUE), 4, false},
    {TERRAZZO_NAME(GL_INDEX_CLEAR_VALUE), 1, false},
    {TERRAZZO_NAME(GL_DEPTH_CLEAR_VALUE), 1, false},
    {TERRAZZO_NAME(GL_STENCIL_CLEAR_VALUE), 1},
    {TERRAZZO_NAME(GL_ACCUM_CLEAR_VALUE), 4, false},
    {TERRAZZO_NAME(GL_UNPACK_SWAP_BYTES), 1},
    {TERRAZZO_NAME(GL_UNPACK_LSB_FIRST), 1},
    {TERRAZZO_NAME(GL_UNPACK_ROW_LENGTH), 1},
    {TERRAZZO_NAME(GL_UNPACK_SKIP_ROWS), 1},
    {TERRAZZO_NAME(GL_UNPACK_SKIP_PIXELS), 1},
    {TERRAZZO_NAME(GL_UNPACK_ALIGNMENT), 1},
    {TERRAZZO_NAME(GL_PACK_SWAP_BYTES), 1},
    {TERRAZZO_NAME(GL_PACK_LSB_FIRST), 1},
    {TERRAZZO_NAME(GL_PACK_ROW_LENGTH), 1},
    {TERRAZZO_NAME(GL_PACK_SKIP_ROWS), 1},
    {TERRAZZO_NAME(GL_PACK_SKIP_PIXELS), 1},
    {TERRAZZO_NAME(GL_PACK_ALIGNMENT), 1},
    {TERRAZZO_NAME(GL_MAP_COLOR), 1},
    {TERRAZZO_NAME(GL_MAP_STENCIL), 1},
    {TERRAZZO_NAME(GL_INDEX_SHIFT), 1},
    {TERRAZZO_NAME(GL_INDEX_OFFSET), 1},
    {TERRAZZO_NAME(GL_RED_SCALE), 1, false},
    {TERRAZZO_NAME(GL_GREEN_SCALE), 1, false},
    {TERRAZZO_NAME(GL_BLUE_SCALE), 1, false},
    {TERRAZZO_NAME(GL_ALPHA_SCALE), 1, false},
    {TERRAZZO_NAME(GL_RED_BIAS), 1, false},
    {TERRAZZO_NAME(GL_GREEN_BIAS), 1, false},
    {TERRAZZO_NAME(GL_BLUE_BIAS), 1, false},
    {TERRAZZO_NAME(GL_ALPHA_BIAS), 1, false},
    {TERRAZZO_NAME(GL_DEPTH_SCALE), 1, false},
    {TERRAZZO_NAME(GL_DEPTH_BIAS), 1, false},
    {TERRAZZO_NAME(GL_ZOOM_X), 1, false},
    {TERRAZZO_NAME(GL_ZOOM_Y), 1, false},
    {TERRAZZO_NAME(GL_PERSPECTIVE_CORRECTION_HINT), 1},
    {TERRAZZO_NAME(GL_POINT_SMOOTH_HINT), 1},
    {TERRAZZO_NAME(GL_LINE_SMOOTH_HINT), 1},
    {TERRAZZO_NAME(GL_POLYGON_SMOOTH_HINT), 1},
    {TERRAZZO_NAME(GL_FOG_HINT), 1},
    {TERRAZZO_NAME(GL_GENERATE_MIPMAP_HINT), 1},
    {TERRAZZO_NAME(GL_TEXTURE_COMPRESSION_HINT), 1},
    {TERRAZZO_NAME(GL_ATTRIB_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_CLIENT_ATTRIB_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_LIGHTS), 1},
    {TERRAZZO_NAME(GL_MAX_MODELVIEW_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_PROJECTION_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_TEXTURE_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_ATTRIB_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_NAME_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_MAX_LIST_NESTING), 1},
    {TERRAZZO_NAME(GL_MAX_PIXEL_MAP_TABLE), 1},
    {TERRAZZO_NAME(GL_MAX_TEXTURE_SIZE), 1},
    {TERRAZZO_NAME(GL_MAX_VIEWPORT_DIMS), 2},
    {TERRAZZO_NAME(GL_SUBPIXEL_BITS), 1},
    {TERRAZZO_NAME(GL_POINT_SIZE_RANGE), 2},
    {TERRAZZO_NAME(GL_POINT_SIZE_GRANULARITY), 1},
    {TERRAZZO_NAME(GL_ALIASED_POINT_SIZE_RANGE), 2},
    {TERRAZZO_NAME(GL_LINE_WIDTH_RANGE), 2},
    {TERRAZZO_NAME(GL_LINE_WIDTH_GRANULARITY), 1},
    {TERRAZZO_NAME(GL_ALIASED_LINE_WIDTH_RANGE), 2},
    {TERRAZZO_NAME(GL_RGBA_MODE), 1},
    {TERRAZZO_NAME(GL_INDEX_MODE), 1},
    {TERRAZZO_NAME(GL_DOUBLEBUFFER), 1},
    {TERRAZZO_NAME(GL_STEREO), 1},
    {TERRAZZO_NAME(GL_AUX_BUFFERS), 1},
    {TERRAZZO_NAME(GL_INDEX_BITS), 1},
    {TERRAZZO_NAME(GL_RENDER_MODE), 1},
    {TERRAZZO_NAME(GL_CURRENT_COLOR), 4, false},
    {TERRAZZO_NAME(GL_CURRENT_INDEX), 1, false},
    {TERRAZZO_NAME(GL_CURRENT_NORMAL), 3, false},
    {TERRAZZO_NAME(GL_CURRENT_TEXTURE_COORDS), 4, false},
    {TERRAZZO_NAME(GL_EDGE_FLAG), 1},
    {TERRAZZO_NAME(GL_CURRENT_RASTER_POSITION), 4, false},
    {TERRAZZO_NAME(GL_CURRENT_RASTER_DISTANCE), 1, false},
    {TERRAZZO_NAME(GL_CURRENT_RASTER_COLOR), 4, false},
    {TERRAZZO_NAME(GL_CURRENT_RASTER_TEXTURE_COORDS), 4, false},
    {TERRAZZO_NAME(GL_CURRENT_RASTER_POSITION_VALID), 1},
    {TERRAZZO_NAME(GL_VERTEX_ARRAY_SIZE), 1},
    {TERRAZZO_NAME(GL_VERTEX_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_VERTEX_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_NORMAL_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_NORMAL_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_COLOR_ARRAY_SIZE), 1},
    {TERRAZZO_NAME(GL_COLOR_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_COLOR_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_INDEX_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_INDEX_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_SIZE), 1},
    {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_EDGE_FLAG_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_SECONDARY_COLOR_ARRAY_SIZE), 1},
    {TERRAZZO_NAME(GL_SECONDARY_COLOR_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_SECONDARY_COLOR_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_FOG_COORDINATE_ARRAY_TYPE), 1},
    {TERRAZZO_NAME(GL_FOG_COORDINATE_ARRAY_STRIDE), 1},
    {TERRAZZO_NAME(GL_CURRENT_SECONDARY_COLOR), 4, false},
    {TERRAZZO_NAME(GL_CURRENT_FOG_COORDINATE), 1, false},
    {TERRAZZO_NAME(GL_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_ELEMENT_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_PIXEL_PACK_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_PIXEL_UNPACK_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_VERTEX_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_NORMAL_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_COLOR_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_INDEX_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_EDGE_FLAG_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING), 1},
    {TERRAZZO_NAME(GL_TRANSPOSE_MODELVIEW_MATRIX), 16, false},
    {TERRAZZO_NAME(GL_TRANSPOSE_PROJECTION_MATRIX), 16, false},
    {TERRAZZO_NAME(GL_BLEND_SRC_RGB), 1},
    {TERRAZZO_NAME(GL_BLEND_SRC_ALPHA), 1},
    {TERRAZZO_NAME(GL_BLEND_DST_RGB), 1},
    {TERRAZZO_NAME(GL_BLEND_DST_ALPHA), 1},
    {TERRAZZO_NAME(GL_BLEND_EQUATION_RGB), 1},
    {TERRAZZO_NAME(GL_BLEND_EQUATION_ALPHA), 1},
    {TERRAZZO_NAME(GL_BLEND_COLOR), 4, false},
    {TERRAZZO_NAME(GL_UNPACK_IMAGE_HEIGHT), 1},
    {TERRAZZO_NAME(GL_UNPACK_SKIP_IMAGES), 1},
    {TERRAZZO_NAME(GL_PACK_IMAGE_HEIGHT), 1},
    {TERRAZZO_NAME(GL_PACK_SKIP_IMAGES), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_I_TO_I_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_S_TO_S_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_I_TO_R_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_I_TO_G_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_I_TO_B_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_I_TO_A_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_R_TO_R_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_G_TO_G_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_B_TO_B_SIZE), 1},
    {TERRAZZO_NAME(GL_PIXEL_MAP_A_TO_A_SIZE), 1},
    {TERRAZZO_NAME(GL_LIST_BASE), 1},
    {TERRAZZO_NAME(GL_MAP1_GRID_DOMAIN), 2, false},
    {TERRAZZO_NAME(GL_MAP1_GRID_SEGMENTS), 1},
    {TERRAZZO_NAME(GL_MAP2_GRID_DOMAIN), 4, false},
    {TERRAZZO_NAME(GL_MAP2_GRID_SEGMENTS), 2},
    {TERRAZZO_NAME(GL_MAX_EVAL_ORDER), 1},
    {TERRAZZO_NAME(GL_NAME_STACK_DEPTH), 1},
    {TERRAZZO_NAME(GL_SELECTION_BUFFER_SIZE), 1},
    {TERRAZZO_NAME(GL_FEEDBACK_BUFFER_SIZE), 1},
    {TERRAZZO_NAME(GL_FEEDBACK_BUFFER_TYPE), 1},
    {TERRAZZO_NAME(GL_ACCUM_RED_BITS), 1},
    {TERRAZZO_NAME(GL_ACCUM_ALPHA_BITS), 1},
    {TERRAZZO_NAME(GL_LIST_INDEX), 1},
    {TERRAZZO_NAME(GL_LIST_MODE), 1},
    {TERRAZZO_NAME(GL_MAX_ELEMENTS_VERTICES), 1},
    {TERRAZZO_NAME(GL_MAX_ELEMENTS_INDICES), 1},
    {TERRAZZO_NAME(GL_RED_BITS), 1},
    {TERRAZZO_NAME(GL_GREEN_BITS), 1},
    {TERRAZZO_NAME(GL_BLUE_BITS), 1},
    {TERRAZZO_NAME(GL_ALPHA_BITS), 1},
    {TERRAZZO_NAME(GL_DEPTH_BITS), 1},
    {TERRAZZO_NAME(GL_STENCIL_BITS), 1},
};

constexpr Name kCapabilities[] = {
    TERRAZZO_NAME(GL_EDGE_FLAG_ARRAY),
    TERRAZZO_NAME(GL_SECONDARY_COLOR_ARRAY),
    TERRAZZO_NAME(GL_FOG_COORDINATE_ARRAY),
    TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY),
    TERRAZZO_NAME(GL_INDEX_ARRAY),
    TERRAZZO_NAME(GL_COLOR_ARRAY),
    TERRAZZO_NAME(GL_NORMAL_ARRAY),
    TERRAZZO_NAME(GL_VERTEX_ARRAY),
    TERRAZZO_NAME(GL_ALPHA_TEST),
    TERRAZZO_NAME(GL_BLEND),
    TERRAZZO_NAME(GL_CLIP_PLANE0),
    TERRAZZO_NAME(GL_CLIP_PLANE1),
    TERRAZZO_NAME(GL_CLIP_PLANE5),
    TERRAZZO_NAME(GL_COLOR_LOGIC_OP),
    TERRAZZO_NAME(GL_COLOR_MATERIAL),
    TERRAZZO_NAME(GL_COLOR_SUM),
    TERRAZZO_NAME(GL_CULL_FACE),
    TERRAZZO_NAME(GL_DEPTH_TEST),
    TERRAZZO_NAME(GL_DITHER),
    TERRAZZO_NAME(GL_FOG),
    TERRAZZO_NAME(GL_INDEX_LOGIC_OP),
    TERRAZZO_NAME(GL_LIGHT0),
    TERRAZZO_NAME(GL_LIGHT1),
    TERRAZZO_NAME(GL_LIGHT7),
    TERRAZZO_NAME(GL_LIGHTING),
    TERRAZZO_NAME(GL_LINE_SMOOTH),
    TERRAZZO_NAME(GL_LINE_STIPPLE),
    TERRAZZO_NAME(GL_MULTISAMPLE),
    TERRAZZO_NAME(GL_SAMPLE_ALPHA_TO_COVERAGE),
    TERRAZZO_NAME(GL_SAMPLE_ALPHA_TO_ONE),
    TERRAZZO_NAME(GL_SAMPLE_COVERAGE),
    TERRAZZO_NAME(GL_NORMALIZE),
    TERRAZZO_NAME(GL_POINT_SMOOTH),
    TERRAZZO_NAME(GL_POINT_SPRITE),
    TERRAZZO_NAME(GL_POLYGON_OFFSET_FILL),
    TERRAZZO_NAME(GL_POLYGON_OFFSET_LINE),
    TERRAZZO_NAME(GL_POLYGON_OFFSET_POINT),
    TERRAZZO_NAME(GL_POLYGON_SMOOTH),
    TERRAZZO_NAME(GL_POLYGON_STIPPLE),
    TERRAZZO_NAME(GL_RESCALE_NORMAL),
    TERRAZZO_NAME(GL_DEPTH_CLAMP),
    TERRAZZO_NAME(GL_SCISSOR_TEST),
    TERRAZZO_NAME(GL_STENCIL_TEST),
    TERRAZZO_NAME(GL_TEXTURE_1D),
    TERRAZZO_NAME(GL_TEXTURE_2D),
    TERRAZZO_NAME(GL_TEXTURE_3D),
    TERRAZZO_NAME(GL_TEXTURE_CUBE_MAP),
    TERRAZZO_NAME(GL_TEXTURE_GEN_Q),
    TERRAZZO_NAME(GL_AUTO_NORMAL),
    TERRAZZO_NAME(GL_MAP1_COLOR_4),
    TERRAZZO_NAME(GL_MAP1_INDEX),
    TERRAZZO_NAME(GL_MAP1_NORMAL),
    TERRAZZO_NAME(GL_MAP1_TEXTURE_COORD_1),
    TERRAZZO_NAME(GL_MAP1_TEXTURE_COORD_2),
    TERRAZZO_NAME(GL_MAP1_TEXTURE_COORD_3),
    TERRAZZO_NAME(GL_MAP1_TEXTURE_COORD_4),
    TERRAZZO_NAME(GL_MAP1_VERTEX_3),
    TERRAZZO_NAME(GL_MAP1_VERTEX_4),
    TERRAZZO_NAME(GL_MAP2_COLOR_4),
    TERRAZZO_NAME(GL_MAP2_INDEX),
    TERRAZZO_NAME(GL_MAP2_NORMAL),
    TERRAZZO_NAME(GL_MAP2_TEXTURE_COORD_1),
    TERRAZZO_NAME(GL_MAP2_TEXTURE_COORD_2),
    TERRAZZO_NAME(GL_MAP2_TEXTURE_COORD_3),
    TERRAZZO_NAME(GL_MAP2_TEXTURE_COORD_4),
    TERRAZZO_NAME(GL_MAP2_VERTEX_3),
    TERRAZZO_NAME(GL_MAP2_VERTEX_4),
    TERRAZZO_NAME(GL_TEXTURE_GEN_R),
    TERRAZZO_NAME(GL_TEXTURE_GEN_S),
    TERRAZZO_NAME(GL_TEXTURE_GEN_T),
};

// Parameters of objects within the context: lights, materials, coordinate generation, environment.
struct Parameter {
    Name name;
    int count;
    bool integers = false;
};

constexpr Parameter kLightParameters[] = {
    {TERRAZZO_NAME(GL_AMBIENT), 4},
    {TERRAZZO_NAME(GL_DIFFUSE), 4},
    {TERRAZZO_NAME(GL_SPECULAR), 4},
    {TERRAZZO_NAME(GL_POSITION), 4},
    {TERRAZZO_NAME(GL_SPOT_DIRECTION), 3},
    {TERRAZZO_NAME(GL_SPOT_EXPONENT), 1},
    {TERRAZZO_NAME(GL_SPOT_CUTOFF), 1},
    {TERRAZZO_NAME(GL_CONSTANT_ATTENUATION), 1},
    {TERRAZZO_NAME(GL_LINEAR_ATTENUATION), 1},
    {TERRAZZO_NAME(GL_QUADRATIC_ATTENUATION), 1},
};

constexpr Parameter kMaterialParameters[] = {
    {TERRAZZO_NAME(GL_AMBIENT), 4},  {TERRAZZO_NAME(GL_DIFFUSE), 4},   {TERRAZZO_NAME(GL_SPECULAR), 4},
    {TERRAZZO_NAME(GL_EMISSION), 4}, {TERRAZZO_NAME(GL_SHININESS), 1}, {TERRAZZO_NAME(GL_COLOR_INDEXES), 3},
};

constexpr Parameter kTexgenParameters[] = {
    {TERRAZZO_NAME(GL_TEXTURE_GEN_MODE), 1, true},
    {TERRAZZO_NAME(GL_OBJECT_PLANE), 4},
    {TERRAZZO_NAME(GL_EYE_PLANE), 4},
};

constexpr Parameter kEnvironmentParameters[] = {
    {TERRAZZO_NAME(GL_TEXTURE_ENV_MODE), 1, true}, {TERRAZZO_NAME(GL_TEXTURE_ENV_COLOR), 4},
    {TERRAZZO_NAME(GL_COMBINE_RGB), 1, true},      {TERRAZZO_NAME(GL_COMBINE_ALPHA), 1, true},
    {TERRAZZO_NAME(GL_SRC0_RGB), 1, true},         {TERRAZZO_NAME(GL_SRC1_RGB), 1, true},
    {TERRAZZO_NAME(GL_SRC2_RGB), 1, true},         {TERRAZZO_NAME(GL_SRC0_ALPHA), 1, true},
    {TERRAZZO_NAME(GL_SRC1_ALPHA), 1, true},       {TERRAZZO_NAME(GL_SRC2_ALPHA), 1, true},
    {TERRAZZO_NAME(GL_OPERAND0_RGB), 1, true},     {TERRAZZO_NAME(GL_OPERAND1_RGB), 1, true},
    {TERRAZZO_NAME(GL_OPERAND2_RGB), 1, true},     {TERRAZZO_NAME(GL_OPERAND0_ALPHA), 1, true},
    {TERRAZZO_NAME(GL_OPERAND1_ALPHA), 1, true},   {TERRAZZO_NAME(GL_OPERAND2_ALPHA), 1, true},
    {TERRAZZO_NAME(GL_RGB_SCALE), 1, true},        {TERRAZZO_NAME(GL_ALPHA_SCALE), 1, true},
};

constexpr Parameter kTextureParameters[] = {
    {TERRAZZO_NAME(GL_TEXTURE_MIN_FILTER), 1, true},   {TERRAZZO_NAME(GL_TEXTURE_MAG_FILTER), 1, true},
    {TERRAZZO_NAME(GL_TEXTURE_WRAP_S), 1, true},       {TERRAZZO_NAME(GL_TEXTURE_WRAP_T), 1, true},
    {TERRAZZO_NAME(GL_TEXTURE_WRAP_R), 1, true},       {TERRAZZO_NAME(GL_DEPTH_TEXTURE_MODE), 1, true},
    {TERRAZZO_NAME(GL_TEXTURE_COMPARE_MODE), 1, true}, {TERRAZZO_NAME(GL_TEXTURE_COMPARE_FUNC), 1, true},
    {TERRAZZO_NAME(GL_TEXTURE_BORDER_COLOR), 4},       {TERRAZZO_NAME(GL_TEXTURE_PRIORITY), 1},
    {TERRAZZO_NAME(GL_TEXTURE_LOD_BIAS), 1},           {TERRAZZO_NAME(GL_GENERATE_MIPMAP), 1, true},
    {TERRAZZO_NAME(GL_TEXTURE_MAX_ANISOTROPY_EXT), 1},
};

constexpr Name kTextureTargets[] = {TERRAZZO_NAME(GL_TEXTURE_1D), TERRAZZO_NAME(GL_TEXTURE_2D),
                                    TERRAZZO_NAME(GL_TEXTURE_3D), TERRAZZO_NAME(GL_TEXTURE_CUBE_MAP)};
constexpr Name kPointers[] = {
    TERRAZZO_NAME(GL_VERTEX_ARRAY_POINTER),          TERRAZZO_NAME(GL_NORMAL_ARRAY_POINTER),
    TERRAZZO_NAME(GL_COLOR_ARRAY_POINTER),           TERRAZZO_NAME(GL_INDEX_ARRAY_POINTER),
    TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_POINTER),   TERRAZZO_NAME(GL_EDGE_FLAG_ARRAY_POINTER),
    TERRAZZO_NAME(GL_SECONDARY_COLOR_ARRAY_POINTER), TERRAZZO_NAME(GL_FOG_COORDINATE_ARRAY_POINTER),
};
struct BufferTarget {
    Name target;
    GLenum binding;
};
constexpr BufferTarget kBufferTargets[] = {
    {TERRAZZO_NAME(GL_ARRAY_BUFFER), GL_ARRAY_BUFFER_BINDING},
    {TERRAZZO_NAME(GL_ELEMENT_ARRAY_BUFFER), GL_ELEMENT_ARRAY_BUFFER_BINDING},
    {TERRAZZO_NAME(GL_PIXEL_PACK_BUFFER), GL_PIXEL_PACK_BUFFER_BINDING},
    {TERRAZZO_NAME(GL_PIXEL_UNPACK_BUFFER), GL_PIXEL_UNPACK_BUFFER_BINDING},
};
constexpr Name kBufferParameters[] = {TERRAZZO_NAME(GL_BUFFER_SIZE), TERRAZZO_NAME(GL_BUFFER_USAGE),
                                      TERRAZZO_NAME(GL_BUFFER_ACCESS), TERRAZZO_NAME(GL_BUFFER_MAPPED)};
constexpr Name kLights[] = {TERRAZZO_NAME(GL_LIGHT0), TERRAZZO_NAME(GL_LIGHT1), TERRAZZO_NAME(GL_LIGHT7)};
constexpr Name kFaces[] = {TERRAZZO_NAME(GL_FRONT), TERRAZZO_NAME(GL_BACK)};
constexpr Name kCoordinates[] = {TERRAZZO_NAME(GL_S), TERRAZZO_NAME(GL_T), TERRAZZO_NAME(GL_R),
                                 TERRAZZO_NAME(GL_Q)};
constexpr Name kClipPlanes[] = {TERRAZZO_NAME(GL_CLIP_PLANE0), TERRAZZO_NAME(GL_CLIP_PLANE1),
                                TERRAZZO_NAME(GL_CLIP_PLANE5)};
constexpr Name kFilterControls[] = {TERRAZZO_NAME(GL_TEXTURE_FILTER_CONTROL)};
constexpr Parameter kFilterControlParameters[] = {{TERRAZZO_NAME(GL_TEXTURE_LOD_BIAS), 1}};
constexpr Name kPointSprites[] = {TERRAZZO_NAME(GL_POINT_SPRITE)};
constexpr Parameter kPointSpriteParameters[] = {{TERRAZZO_NAME(GL_COORD_REPLACE), 1, true}};
constexpr Name kEnvironments[] = {TERRAZZO_NAME(GL_TEXTURE_ENV)};

// -0 is written as 0: which of them a matrix product gives depends, in the reference, on when it last looked
// at the matrix.
std::string text(GLdouble value) {
    char buffer[64] = " ";
    return {buffer, std::to_chars(buffer + 1, std::end(buffer), value + 0.0, std::chars_format::hex).ptr};
}

// One query; values that it must not write would show as the pattern it starts from.
template <typename Value, typename Query>
std::string query_line(const std::string& name, const char* type, int count, Query query) {
    Value values[16];
    std::fill(std::begin(values), std::end(values), static_cast<Value>(77));
    query(values);
    std::string line = name + ' ' + type;
    for (int i = 0; i < count; ++i) line += text(static_cast<GLdouble>(values[i]));
    return line;
}

using Dump = std::vector<std::string>;

void dump_variables(const kit::Gl& gl, Dump& dump) {
    for (const auto& [name, count, integers] : kVariables) {
        const GLenum v = name.value;
        dump.push_back(
            query_line<GLboolean>(name.text, "boolean", count, [&](auto* p) { gl.GetBooleanv(v, p); }));
        if (integers) {
            dump.push_back(
                query_line<GLint>(name.text, "int", count, [&](auto* p) { gl.GetIntegerv(v, p); }));
        }
        dump.push_back(query_line<GLfloat>(name.text, "float", count, [&](auto* p) { gl.GetFloatv(v, p); }));
        dump.push_back(
            query_line<GLdouble>(name.text, "double", count, [&](auto* p) { gl.GetDoublev(v, p); }));
    }
}

void dump_capabilities(const kit::Gl& gl, Dump& dump) {
    for (const Name& name : kCapabilities) {
        dump.push_back(name.text + std::string(gl.IsEnabled(name.value) ? " enabled" : " disabled"));
        dump.push_back(
            query_line<GLint>(name.text, "int", 1, [&](auto* p) { gl.GetIntegerv(name.value, p); }));
    }
}

// The fv and iv queries of every parameter of every object.
template <typename Objects, typename Parameters, typename Floats, typename Integers>
void dump_objects(const Objects& objects, const Parameters& parameters, Floats floats, Integers integers,
                  Dump& dump) {
    for (const Name& object : objects) {
        for (const Parameter& parameter : parameters) {
            const std::string name = std::string(object.text) + '.' + parameter.name.text;
            dump.push_back(query_line<GLfloat>(name, "float", parameter.count, [&](auto* p) {
                floats(object.value, parameter.name.value, p);
            }));
            if (!parameter.integers) continue;
            dump.push_back(query_line<GLint>(name, "int", parameter.count, [&](auto* p) {
                integers(object.value, parameter.name.value, p);
            }));
        }
    }
}

// The buffer objects that are bound; as many lines where there are none.
void dump_buffers(const kit::Gl& gl, Dump& dump) {
    for (const BufferTarget& buffer : kBufferTargets) {
        const Name& target = buffer.target;
        GLint bound = 0;
        gl.GetIntegerv(buffer.binding, &bound);
        for (const Name& parameter : kBufferParameters) {
            dump.push_back(
                query_line<GLint>(std::string(target.text) + '.' + parameter.text, "int", 1, [&](auto* p) {
                    if (bound != 0) gl.GetBufferParameteriv(target.value, parameter.value, p);
                }));
        }
        void* pointer = nullptr;
        if (bound != 0) gl.GetBufferPointerv(target.value, GL_BUFFER_MAP_POINTER, &pointer);
        dump.push_back(target.text + text(pointer != nullptr));
    }
}

void dump_polygon_stipple(const kit::Gl& gl, Dump& dump) {
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (GLenum parameter : {GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS}) {
        gl.PixelStorei(parameter, 0);
    }
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    GLubyte pattern[128] = {};
    gl.GetPolygonStipple(pattern);
    gl.PopClientAttrib();
    std::string line = "POLYGON_STIPPLE";
    for (GLubyte byte : pattern) line += text(byte);
    dump.push_back(line);
}

}  // namespace

std::vector<std::string> dump_state(const kit::Gl& gl) {
    Dump dump;
    dump_variables(gl, dump);
    dump_capabilities(gl, dump);
    dump_objects(kLights, kLightParameters, gl.GetLightfv, gl.GetLightiv, dump);
    dump_objects(kFaces, kMaterialParameters, gl.GetMaterialfv, gl.GetMaterialiv, dump);
    dump_objects(kCoordinates, kTexgenParameters, gl.GetTexGenfv, gl.GetTexGeniv, dump);
    dump_objects(kEnvironments, kEnvironmentParameters, gl.GetTexEnvfv, gl.GetTexEnviv, dump);
    dump_objects(kFilterControls, kFilterControlParameters, gl.GetTexEnvfv, gl.GetTexEnviv, dump);
    dump_objects(kPointSprites, kPointSpriteParameters, gl.GetTexEnvfv, gl.GetTexEnviv, dump);
    dump_objects(kTextureTargets, kTextureParameters, gl.GetTexParameterfv, gl.GetTexParameteriv, dump);
    for (const Name& plane : kClipPlanes) {
        dump.push_back(
            query_line<GLdouble>(plane.text, "double", 4, [&](auto* p) { gl.GetClipPlane(plane.value, p); }));
    }
    for (const Name& name : kPointers) {
        void* pointer = nullptr;
        gl.GetPointerv(name.value, &pointer);
        dump.push_back(name.text + text(static_cast<GLdouble>(reinterpret_cast<std::uintptr_t>(pointer))));
    }
    dump_buffers(gl, dump);
    dump.push_back(query_line<GLint>("GL_CURRENT_QUERY", "int", 1, [&](auto* p) {
        gl.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, p);
    }));
    dump_polygon_stipple(gl, dump);
    dump.push_back("error after the queries" + text(gl.GetError()));
    return dump;
}

namespace {

std::string numbered(const char* name, GLenum first, GLenum value) {
    return name + std::to_string(value - first);
}

template <std::size_t kCount>
std::vector<Name> enumerated(GLenum first, const char* name, std::array<std::string, kCount>& texts) {
    std::vector<Name> out;
    for (std::size_t i = 0; i < kCount; ++i) {
        texts[i] = name + std::to_string(i);
        out.push_back({first + static_cast<GLenum>(i), texts[i].c_str()});
    }
    return out;
}

void dump_lights_and_planes(const kit::Gl& gl, Dump& dump) {
    std::array<std::string, 8> lights;
    dump_objects(enumerated(GL_LIGHT0, "light", lights), kLightParameters, gl.GetLightfv, gl.GetLightiv,
                 dump);
    for (GLenum plane = GL_CLIP_PLANE0; plane <= GL_CLIP_PLANE5; ++plane) {
        dump.push_back(query_line<GLdouble>(numbered("plane", GL_CLIP_PLANE0, plane), "double", 4,
                                            [&](auto* p) { gl.GetClipPlane(plane, p); }));
    }
    for (GLenum first : {GLenum{GL_LIGHT0}, GLenum{GL_CLIP_PLANE0}}) {
        for (GLenum i = 0; i < (first == GL_LIGHT0 ? 8u : 6u); ++i)
            dump.push_back(numbered("capability", 0, first + i) + text(gl.IsEnabled(first + i)));
    }
}

// GL_CURRENT_RASTER_TEXTURE_COORDS and the matrices too: all that belongs to a unit.
void dump_units(const kit::Gl& gl, Dump& dump) {
    GLint active = 0, client_active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    gl.GetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &client_active);
    constexpr Variable kUnit[] = {{TERRAZZO_NAME(GL_CURRENT_TEXTURE_COORDS), 4},
                                  {TERRAZZO_NAME(GL_CURRENT_RASTER_TEXTURE_COORDS), 4},
                                  {TERRAZZO_NAME(GL_TEXTURE_MATRIX), 16},
                                  {TERRAZZO_NAME(GL_TEXTURE_STACK_DEPTH), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_BINDING_1D), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_BINDING_2D), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_BINDING_3D), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_BINDING_CUBE_MAP), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_1D), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_2D), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_3D), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_CUBE_MAP), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_GEN_S), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_GEN_T), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_GEN_R), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_GEN_Q), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_SIZE), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_TYPE), 1},
                                  {TERRAZZO_NAME(GL_TEXTURE_COORD_ARRAY_STRIDE), 1}};
    for (GLenum unit = GL_TEXTURE0; unit <= GL_TEXTURE7; ++unit) {
        gl.ActiveTexture(unit);
        gl.ClientActiveTexture(unit);
        dump.push_back(numbered("unit ", GL_TEXTURE0, unit));
        for (const Variable& v : kUnit) {
            dump.push_back(query_line<GLfloat>(v.name.text, "float", v.count,
                                               [&](auto* p) { gl.GetFloatv(v.name.value, p); }));
        }
        dump_objects(kCoordinates, kTexgenParameters, gl.GetTexGenfv, gl.GetTexGeniv, dump);
        dump_objects(kEnvironments, kEnvironmentParameters, gl.GetTexEnvfv, gl.GetTexEnviv, dump);
        dump_objects(kFilterControls, kFilterControlParameters, gl.GetTexEnvfv, gl.GetTexEnviv, dump);
        dump_objects(kPointSprites, kPointSpriteParameters, gl.GetTexEnvfv, gl.GetTexEnviv, dump);
    }
    gl.ActiveTexture(static_cast<GLenum>(active));
    gl.ClientActiveTexture(static_cast<GLenum>(client_active));
}

// The images of the active unit's textures, as the floats that they are read back as.
void dump_images(const kit::Gl& gl, Dump& dump) {
    constexpr GLenum kImages[] = {GL_TEXTURE_1D,
                                  GL_TEXTURE_2D,
                                  GL_TEXTURE_3D,
                                  GL_TEXTURE_CUBE_MAP_POSITIVE_X,
                                  GL_TEXTURE_CUBE_MAP_NEGATIVE_X,
                                  GL_TEXTURE_CUBE_MAP_POSITIVE_Y,
                                  GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
                                  GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
                                  GL_TEXTURE_CUBE_MAP_NEGATIVE_Z};
    constexpr GLenum kLevel[] = {GL_TEXTURE_WIDTH,      GL_TEXTURE_HEIGHT,          GL_TEXTURE_DEPTH,
                                 GL_TEXTURE_BORDER,     GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_RED_SIZE,
                                 GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE,  GL_TEXTURE_INTENSITY_SIZE,
                                 GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_COMPRESSED};
    for (GLenum image : kImages) {
        for (GLint level = 0; level < 2; ++level) {
            std::string line = "image " + std::to_string(image) + " level " + std::to_string(level);
            GLint values[std::size(kLevel)] = {};
            for (std::size_t i = 0; i < std::size(kLevel); ++i) {
                gl.GetTexLevelParameteriv(image, level, kLevel[i], &values[i]);
                line += ' ' + std::to_string(values[i]);
            }
            const auto texels = static_cast<std::size_t>(values[0]) *
                                static_cast<std::size_t>(std::max(values[1], 1)) *
                                static_cast<std::size_t>(std::max(values[2], 1));
            if (texels > 0 && texels <= 4096) {
                std::vector<GLfloat> read(texels * 4);
                gl.GetTexImage(image, level, values[9] ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, read.data());
                std::uint64_t hash = 1469598103934665603u;
                for (GLfloat value : read) {
                    hash = (hash ^ std::bit_cast<std::uint32_t>(value + 0.0f)) * 1099511628211u;
                }
                line += " texels " + std::to_string(hash);
            }
            dump.push_back(line);
        }
    }
}

void dump_pixel_maps(const kit::Gl& gl, Dump& dump) {
    for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
        GLint size = 0;
        gl.GetIntegerv(GL_PIXEL_MAP_I_TO_I_SIZE + (map - GL_PIXEL_MAP_I_TO_I), &size);
        GLfloat values[256] = {};
        gl.GetPixelMapfv(map, values);
        std::string line = numbered("pixel map ", GL_PIXEL_MAP_I_TO_I, map);
        for (GLint i = 0; i < std::clamp(size, 0, 256); ++i) line += text(static_cast<GLdouble>(values[i]));
        dump.push_back(line);
    }
}

void dump_evaluators(const kit::Gl& gl, Dump& dump) {
    for (GLenum first : {GLenum{GL_MAP1_COLOR_4}, GLenum{GL_MAP2_COLOR_4}}) {
        const int dimensions = first == GL_MAP1_COLOR_4 ? 1 : 2;
        for (GLenum map = first; map < first + 9; ++map) {
            GLint orders[2] = {0, 1};
            GLfloat domain[4] = {}, points[4 * 64] = {};
            gl.GetMapiv(map, GL_ORDER, orders);
            gl.GetMapfv(map, GL_DOMAIN, domain);
            if (orders[0] * orders[1] <= 64) gl.GetMapfv(map, GL_COEFF, points);
            std::string line = numbered("map ", 0, map) + text(orders[0]) + text(orders[1]);
            for (int i = 0; i < 2 * dimensions; ++i) line += text(static_cast<GLdouble>(domain[i]));
            for (GLfloat point : points) line += text(static_cast<GLdouble>(point));
            dump.push_back(line);
        }
    }
}

}  // namespace

std::vector<std::string> dump_everything(const kit::Gl& gl) {
    Dump dump = dump_state(gl);
    dump_lights_and_planes(gl, dump);
    dump_units(gl, dump);
    // Images are packed and read without what the state would make of them.
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    gl.PushAttrib(GL_PIXEL_MODE_BIT);
    constexpr GLenum kPack[] = {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST,   GL_PACK_ROW_LENGTH,
                                GL_PACK_SKIP_ROWS,  GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT,
                                GL_PACK_SKIP_IMAGES};
    for (GLenum mode : kPack) gl.PixelStorei(mode, 0);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    constexpr GLenum kScales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE,
                                  GL_DEPTH_SCALE};
    constexpr GLenum kBiases[] = {GL_RED_BIAS,   GL_GREEN_BIAS, GL_BLUE_BIAS,
                                  GL_ALPHA_BIAS, GL_DEPTH_BIAS, GL_MAP_COLOR};
    for (GLenum scale : kScales) gl.PixelTransferf(scale, 1);
    for (GLenum bias : kBiases) gl.PixelTransferf(bias, 0);
    dump_images(gl, dump);
    dump_pixel_maps(gl, dump);
    gl.PopAttrib();
    gl.PopClientAttrib();
    dump_evaluators(gl, dump);
    dump.push_back("error after all queries" + text(gl.GetError()));
    return dump;
}

std::vector<std::string> changed(const std::vector<std::string>& before,
                                 const std::vector<std::string>& after) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (after[i] != before[i]) lines.push_back(after[i]);
    }
    return lines;
}

}  // namespace terrazzo::test
