// The table of what commands take from the client and from one another: current values, vertex arrays,
// pixels, hints, lists and stacks (GL 1.5 tables 6.5-6.7, 6.22-6.24, 6.28-6.30).
#include "gl/state_table.h"

namespace terrazzo::gl {
namespace {

using Out = StateValues;

const ClientArray& texture_array(const Context& c) {
    return c.arrays.texture[c.arrays.active_texture];
}

// What the client called an array's size.
GLint client_size(const ClientArray& array) {
    return array.bgra ? GL_BGRA : array.size;
}

constexpr auto kVariables = sorted_by_name(std::to_array<StateVariable>({
    // Current values
    {GL_CURRENT_COLOR, [](Context& c, Out& out) { normalized(out, c.vertex.current.color()); }},
    {GL_CURRENT_SECONDARY_COLOR,
     [](Context& c, Out& out) { normalized(out, c.vertex.current.values[pipeline::kSecondaryColor]); }},
    {GL_CURRENT_FOG_COORDINATE,
     [](Context& c, Out& out) { out = c.vertex.current.values[pipeline::kFogCoordinate][0]; }},
    {GL_CURRENT_INDEX, [](Context& c, Out& out) { out = c.vertex.current.index; }},
    {GL_CURRENT_NORMAL,
     [](Context& c, Out& out) {
         const auto& normal = c.vertex.current.values[pipeline::kNormal];
         normalized(out, std::array{normal[0], normal[1], normal[2]});
     }},
    {GL_CURRENT_TEXTURE_COORDS,
     [](Context& c, Out& out) {
         out = c.vertex.current.values[pipeline::kTexture0 + c.texture.active_unit];
     }},
    {GL_EDGE_FLAG, [](Context& c, Out& out) { out = c.vertex.current.values[pipeline::kEdgeFlag][0] != 0; }},
    {GL_CURRENT_RASTER_POSITION, [](Context& c, Out& out) { out = c.raster_position.window; }},
    {GL_CURRENT_RASTER_DISTANCE, [](Context& c, Out& out) { out = c.raster_position.distance; }},
    {GL_CURRENT_RASTER_COLOR, [](Context& c, Out& out) { normalized(out, c.raster_position.color); }},
    {GL_CURRENT_RASTER_INDEX, [](Context& c, Out& out) { out = c.raster_position.index; }},
    {GL_CURRENT_RASTER_TEXTURE_COORDS,
     [](Context& c, Out& out) { out = c.raster_position.texture_coordinates[c.texture.active_unit]; }},
    {GL_CURRENT_RASTER_POSITION_VALID, [](Context& c, Out& out) { out = c.raster_position.valid; }},

    // Vertex arrays
    {GL_VERTEX_ARRAY_SIZE, [](Context& c, Out& out) { out = c.arrays.vertex.size; }},
    {GL_VERTEX_ARRAY_TYPE, [](Context& c, Out& out) { out = c.arrays.vertex.type; }},
    {GL_VERTEX_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.vertex.stride; }},
    {GL_NORMAL_ARRAY_TYPE, [](Context& c, Out& out) { out = c.arrays.normal.type; }},
    {GL_NORMAL_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.normal.stride; }},
    {GL_COLOR_ARRAY_SIZE, [](Context& c, Out& out) { out = client_size(c.arrays.color); }},
    {GL_COLOR_ARRAY_TYPE, [](Context& c, Out& out) { out = c.arrays.color.type; }},
    {GL_COLOR_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.color.stride; }},
    {GL_INDEX_ARRAY_TYPE, [](Context& c, Out& out) { out = c.arrays.index.type; }},
    {GL_INDEX_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.index.stride; }},
    {GL_TEXTURE_COORD_ARRAY_SIZE, [](Context& c, Out& out) { out = texture_array(c).size; }},
    {GL_TEXTURE_COORD_ARRAY_TYPE, [](Context& c, Out& out) { out = texture_array(c).type; }},
    {GL_TEXTURE_COORD_ARRAY_STRIDE, [](Context& c, Out& out) { out = texture_array(c).stride; }},
    {GL_SECONDARY_COLOR_ARRAY_SIZE, [](Context& c, Out& out) { out = client_size(c.arrays.secondary_color); }},
    {GL_SECONDARY_COLOR_ARRAY_TYPE, [](Context& c, Out& out) { out = c.arrays.secondary_color.type; }},
    {GL_SECONDARY_COLOR_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.secondary_color.stride; }},
    {GL_FOG_COORDINATE_ARRAY_TYPE, [](Context& c, Out& out) { out = c.arrays.fog_coordinate.type; }},
    {GL_FOG_COORDINATE_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.fog_coordinate.stride; }},
    {GL_CLIENT_ACTIVE_TEXTURE, [](Context& c, Out& out) { out = GL_TEXTURE0 + c.arrays.active_texture; }},
    {GL_EDGE_FLAG_ARRAY_STRIDE, [](Context& c, Out& out) { out = c.arrays.edge_flag.stride; }},
    {GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, [](Context& c, Out& out) { out = c.arrays.lock_first; }},
    {GL_ARRAY_ELEMENT_LOCK_COUNT_EXT, [](Context& c, Out& out) { out = c.arrays.lock_count; }},

    // Buffer objects
    {GL_PIXEL_PACK_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.pixels.pack.buffer); }},
    {GL_PIXEL_UNPACK_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.pixels.unpack.buffer); }},
    {GL_ARRAY_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.arrays.array_buffer); }},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.arrays.element_buffer); }},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.arrays.vertex.buffer); }},
    {GL_NORMAL_ARRAY_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.arrays.normal.buffer); }},
    {GL_COLOR_ARRAY_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.arrays.color.buffer); }},
    {GL_INDEX_ARRAY_BUFFER_BINDING, [](Context& c, Out& out) { out = name_of(c.arrays.index.buffer); }},
    {GL_EDGE_FLAG_ARRAY_BUFFER_BINDING,
     [](Context& c, Out& out) { out = name_of(c.arrays.edge_flag.buffer); }},
    {GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING,
     [](Context& c, Out& out) { out = name_of(c.arrays.secondary_color.buffer); }},
    {GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING,
     [](Context& c, Out& out) { out = name_of(c.arrays.fog_coordinate.buffer); }},
    {GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING,
     [](Context& c, Out& out) { out = name_of(texture_array(c).buffer); }},

    // Pixels
    {GL_UNPACK_SWAP_BYTES, [](Context& c, Out& out) { out = c.pixels.unpack.swap_bytes; }},
    {GL_UNPACK_LSB_FIRST, [](Context& c, Out& out) { out = c.pixels.unpack.lsb_first; }},
    {GL_UNPACK_ROW_LENGTH, [](Context& c, Out& out) { out = c.pixels.unpack.row_length; }},
    {GL_UNPACK_SKIP_ROWS, [](Context& c, Out& out) { out = c.pixels.unpack.skip_rows; }},
    {GL_UNPACK_SKIP_PIXELS, [](Context& c, Out& out) { out = c.pixels.unpack.skip_pixels; }},
    {GL_UNPACK_ALIGNMENT, [](Context& c, Out& out) { out = c.pixels.unpack.alignment; }},
    {GL_UNPACK_IMAGE_HEIGHT, [](Context& c, Out& out) { out = c.pixels.unpack.image_height; }},
    {GL_UNPACK_SKIP_IMAGES, [](Context& c, Out& out) { out = c.pixels.unpack.skip_images; }},
    {GL_PACK_IMAGE_HEIGHT, [](Context& c, Out& out) { out = c.pixels.pack.image_height; }},
    {GL_PACK_SKIP_IMAGES, [](Context& c, Out& out) { out = c.pixels.pack.skip_images; }},
    {GL_PACK_SWAP_BYTES, [](Context& c, Out& out) { out = c.pixels.pack.swap_bytes; }},
    {GL_PACK_LSB_FIRST, [](Context& c, Out& out) { out = c.pixels.pack.lsb_first; }},
    {GL_PACK_ROW_LENGTH, [](Context& c, Out& out) { out = c.pixels.pack.row_length; }},
    {GL_PACK_SKIP_ROWS, [](Context& c, Out& out) { out = c.pixels.pack.skip_rows; }},
    {GL_PACK_SKIP_PIXELS, [](Context& c, Out& out) { out = c.pixels.pack.skip_pixels; }},
    {GL_PACK_ALIGNMENT, [](Context& c, Out& out) { out = c.pixels.pack.alignment; }},
    {GL_MAP_COLOR, [](Context& c, Out& out) { out = c.pixels.mode.transfer.map_color; }},
    {GL_MAP_STENCIL, [](Context& c, Out& out) { out = c.pixels.mode.transfer.map_stencil; }},
    {GL_INDEX_SHIFT, [](Context& c, Out& out) { out = c.pixels.mode.transfer.index_shift; }},
    {GL_INDEX_OFFSET, [](Context& c, Out& out) { out = c.pixels.mode.transfer.index_offset; }},
    {GL_RED_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[0]; }},
    {GL_GREEN_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[1]; }},
    {GL_BLUE_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[2]; }},
    {GL_ALPHA_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.scale[3]; }},
    {GL_RED_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[0]; }},
    {GL_GREEN_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[1]; }},
    {GL_BLUE_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[2]; }},
    {GL_ALPHA_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.bias[3]; }},
    {GL_DEPTH_SCALE, [](Context& c, Out& out) { out = c.pixels.mode.transfer.depth_scale; }},
    {GL_DEPTH_BIAS, [](Context& c, Out& out) { out = c.pixels.mode.transfer.depth_bias; }},
    {GL_ZOOM_X, [](Context& c, Out& out) { out = c.pixels.mode.zoom_x; }},
    {GL_ZOOM_Y, [](Context& c, Out& out) { out = c.pixels.mode.zoom_y; }},
    {GL_PIXEL_MAP_I_TO_I_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapIToI].size; }},
    {GL_PIXEL_MAP_S_TO_S_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapSToS].size; }},
    {GL_PIXEL_MAP_I_TO_R_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapIToR].size; }},
    {GL_PIXEL_MAP_I_TO_G_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapIToG].size; }},
    {GL_PIXEL_MAP_I_TO_B_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapIToB].size; }},
    {GL_PIXEL_MAP_I_TO_A_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapIToA].size; }},
    {GL_PIXEL_MAP_R_TO_R_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapRToR].size; }},
    {GL_PIXEL_MAP_G_TO_G_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapGToG].size; }},
    {GL_PIXEL_MAP_B_TO_B_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapBToB].size; }},
    {GL_PIXEL_MAP_A_TO_A_SIZE, [](Context& c, Out& out) { out = c.pixels.maps[kMapAToA].size; }},

    // Evaluators
    {GL_MAP1_GRID_DOMAIN,
     [](Context& c, Out& out) {
         const EvaluatorGrid& grid = c.evaluators.modes.grid_1d;
         out = std::array{grid.first, grid.last};
     }},
    {GL_MAP1_GRID_SEGMENTS, [](Context& c, Out& out) { out = c.evaluators.modes.grid_1d.segments; }},
    {GL_MAP2_GRID_DOMAIN,
     [](Context& c, Out& out) {
         const auto& [u, v] = c.evaluators.modes.grid_2d;
         out = std::array{u.first, u.last, v.first, v.last};
     }},
    {GL_MAP2_GRID_SEGMENTS,
     [](Context& c, Out& out) {
         const auto& [u, v] = c.evaluators.modes.grid_2d;
         out = std::array{u.segments, v.segments};
     }},

    // Hints
    {GL_PERSPECTIVE_CORRECTION_HINT, [](Context& c, Out& out) { out = c.hints.perspective_correction; }},
    {GL_POINT_SMOOTH_HINT, [](Context& c, Out& out) { out = c.hints.point_smooth; }},
    {GL_LINE_SMOOTH_HINT, [](Context& c, Out& out) { out = c.hints.line_smooth; }},
    {GL_POLYGON_SMOOTH_HINT, [](Context& c, Out& out) { out = c.hints.polygon_smooth; }},
    {GL_FOG_HINT, [](Context& c, Out& out) { out = c.hints.fog; }},
    {GL_GENERATE_MIPMAP_HINT, [](Context& c, Out& out) { out = c.hints.generate_mipmap; }},
    {GL_TEXTURE_COMPRESSION_HINT, [](Context& c, Out& out) { out = c.hints.texture_compression; }},

    // Display lists
    {GL_LIST_BASE, [](Context& c, Out& out) { out = c.lists.base; }},
    {GL_LIST_INDEX, [](Context& c, Out& out) { out = c.lists.compiling_name; }},
    {GL_LIST_MODE, [](Context& c, Out& out) { out = c.lists.mode; }},

    // Attribute stacks
    {GL_ATTRIB_STACK_DEPTH, [](Context& c, Out& out) { out = c.attrib.server.size(); }},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, [](Context& c, Out& out) { out = c.attrib.client.size(); }},
}));

}  // namespace

std::span<const StateVariable> client_variables() {
    return kVariables;
}

}  // namespace terrazzo::gl
