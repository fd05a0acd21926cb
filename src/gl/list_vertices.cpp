// Collects Begin/End geometry for display lists; see list_vertices.h.
#include "gl/list_vertices.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "gl/generated/compile.h"
#include "gl/generated/records.h"
#include "gl/list_primitives.h"
#include "gl/list_recorder.h"

namespace terrazzo::gl {
namespace {

using Value = std::array<GLfloat, 4>;

template <typename Visit>
void for_each_bit(pipeline::AttributeMask mask, Visit visit) {
    for (; mask != 0; mask &= mask - 1) visit(std::countr_zero(mask));
}

// Bitwise, so that a list keeps negative zeros and whatever a NaN carries.
bool same(const Value& a, const Value& b) {
    return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

void record_call(DisplayList& list, int attribute, const Value& v) {
    switch (attribute) {
        case pipeline::kNormal: {
            auto& r = list.append<Normal3fRecord>();
            r.nx = v[0], r.ny = v[1], r.nz = v[2];
            return;
        }
        case pipeline::kColor: {
            auto& r = list.append<Color4fRecord>();
            r.red = v[0], r.green = v[1], r.blue = v[2], r.alpha = v[3];
            return;
        }
        case pipeline::kEdgeFlag: {
            list.append<EdgeFlagRecord>().flag = v[0] != 0;
            return;
        }
        case pipeline::kTexture0: {
            auto& r = list.append<TexCoord4fRecord>();
            r.s = v[0], r.t = v[1], r.r = v[2], r.q = v[3];
            return;
        }
        case pipeline::kSecondaryColor: {
            auto& r = list.append<SecondaryColor3fRecord>();
            r.red = v[0], r.green = v[1], r.blue = v[2];
            return;
        }
        case pipeline::kFogCoordinate: {
            list.append<FogCoordfRecord>().coord = v[0];
            return;
        }
        case pipeline::kPosition: {
            auto& r = list.append<Vertex4fRecord>();
            r.x = v[0], r.y = v[1], r.z = v[2], r.w = v[3];
            return;
        }
    }
    auto& r = list.append<MultiTexCoord4fRecord>();
    r.target = static_cast<GLenum>(GL_TEXTURE0 + attribute - pipeline::kTexture0);
    r.s = v[0], r.t = v[1], r.r = v[2], r.q = v[3];
}

// How many components of an attribute must be kept: those behind are 0, 0, 1 in all vertices, as the pipeline
// assumes.
std::uint8_t needed_components(const float* values, std::uint32_t count, std::uint32_t stride) {
    constexpr float kMissing[4] = {0, 0, 0, 1};
    for (std::uint8_t components = 4; components > 1; --components) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const float* value = values + std::size_t{i} * stride + components - 1;
            if (std::memcmp(value, &kMissing[components - 1], sizeof(float)) != 0) return components;
        }
    }
    return 1;
}

AttributeValue* store_values(AttributeValue* out, pipeline::AttributeMask mask,
                             const std::array<Value, pipeline::kAttributeCount>& values) {
    for_each_bit(mask, [&](int attribute) {
        *out++ = {static_cast<std::uint32_t>(attribute), values[static_cast<std::size_t>(attribute)]};
    });
    return out;
}

}  // namespace

void ListVertices::begin(DisplayList& list, GLenum mode) {
    if (m_open) record_open_run(list);  // an error when the list is called
    if (m_call_by_call || mode > GL_POLYGON) {
        finish(list);
        list.append<BeginRecord>().mode = mode;
        return;
    }
    // Vertices collected so far take what is current when the list is called; the following ones do not.
    const bool unknown_so_far = (m_changed & ~m_streamed & ~m_constant) != 0;
    if (m_count != 0 && unknown_so_far) finish(list);
    m_open = true;
    m_fourth = 0;
    for_each_bit(m_set & pipeline::kHomogeneous,
                 [&](int a) { note_fourth(a, m_last[static_cast<std::size_t>(a)]); });
    m_mode = mode;
    m_open_first = m_count;
}

void ListVertices::end(DisplayList& list) {
    if (!m_open) {
        finish(list);
        m_call_by_call = false;
        list.append<EndRecord>();
        return;
    }
    add_run(m_runs,
            {.mode = m_mode, .first = m_open_first, .count = m_count - m_open_first, .fourth = m_fourth});
    m_open = false;
}

void ListVertices::vertex(DisplayList& list, const Value& position) {
    if (m_open && m_count != 0 && (m_changed & ~m_streamed & ~m_constant) != 0) record_open_run(list);
    if (!m_open) {
        finish(list);
        return record_call(list, pipeline::kPosition, position);
    }
    if (m_count == 0) {
        m_constant = m_set;
        m_first = m_last;
    } else {
        for_each_bit(m_changed & ~m_streamed, [&](int a) {
            const auto i = static_cast<std::size_t>(a);
            if (!same(m_first[i], m_last[i])) add_stream(a);
        });
    }
    m_changed = 0;
    m_data.insert(m_data.end(), position.begin(), position.end());
    for (const std::uint8_t a : m_streams) m_data.insert(m_data.end(), m_last[a].begin(), m_last[a].end());
    ++m_count;
    note_fourth(pipeline::kPosition, position);
}

void ListVertices::note_fourth(int attribute, const Value& value) {
    if (value[3] != 1) m_fourth |= pipeline::bit(attribute) & pipeline::kHomogeneous;
}

void ListVertices::attribute(DisplayList& list, int attribute, const Value& value) {
    if (m_call_by_call) return record_call(list, attribute, value);
    m_last[static_cast<std::size_t>(attribute)] = value;
    note_fourth(attribute, value);
    m_set |= pipeline::bit(attribute);
    m_changed |= pipeline::bit(attribute);
}

void ListVertices::index(DisplayList& list, GLfloat value) {
    if (m_call_by_call) {
        list.append<IndexfRecord>().c = value;
        return;
    }
    m_index_set = true;
    m_index = value;
}

void ListVertices::finish(DisplayList& list) {
    if (m_open) record_open_run(list);
    if (!m_runs.empty()) {
        record_batch(list);
    } else {
        record_attributes(list, m_set);
        if (m_index_set) list.append<IndexfRecord>().c = m_index;
    }
    start_batch();
}

void ListVertices::start_batch() {
    m_data.clear();
    m_count = 0;
    m_stride = 4;
    m_streams.clear();
    m_runs.clear();
    m_streamed = m_constant = m_set = m_changed = 0;
    m_index_set = false;
}

// Gives an attribute that was constant so far a value of its own in every vertex.
void ListVertices::add_stream(int attribute) {
    const Value& constant = m_first[static_cast<std::size_t>(attribute)];
    std::vector<float> data;
    data.reserve(m_data.size() + m_data.size() / m_stride * 4 + m_stride + 4);
    for (std::uint32_t i = 0; i < m_count; ++i) {
        const auto vertex = m_data.begin() + static_cast<std::ptrdiff_t>(std::size_t{i} * m_stride);
        data.insert(data.end(), vertex, vertex + m_stride);
        data.insert(data.end(), constant.begin(), constant.end());
    }
    m_streams.push_back(static_cast<std::uint8_t>(attribute));
    m_data = std::move(data);
    m_stride += 4;
    m_streamed |= pipeline::bit(attribute);
    m_constant &= ~pipeline::bit(attribute);
}

void ListVertices::record_attributes(DisplayList& list, pipeline::AttributeMask mask) const {
    for_each_bit(mask, [&](int a) { record_call(list, a, m_last[static_cast<std::size_t>(a)]); });
}

// The run that is being collected cannot be part of a batch: everything before it is recorded as one, the run
// itself call by call, and so is what follows until End.
void ListVertices::record_open_run(DisplayList& list) {
    const std::vector<float> vertices(
        m_data.begin() + static_cast<std::ptrdiff_t>(std::size_t{m_open_first} * m_stride), m_data.end());
    const std::vector<std::uint8_t> streams = m_streams;
    const std::uint32_t stride = m_stride;
    const auto first = m_first, last = m_last;
    const pipeline::AttributeMask constant = m_constant, set = m_set;

    m_open = false;
    m_data.resize(std::size_t{m_open_first} * m_stride);
    m_count = m_open_first;
    m_set &= m_streamed | m_constant;  // others were first set in the open run
    if (!m_runs.empty()) {
        record_batch(list);
    } else if (m_index_set) {
        list.append<IndexfRecord>().c = m_index;
    }
    start_batch();
    m_call_by_call = true;

    for_each_bit(constant, [&](int a) { record_call(list, a, first[static_cast<std::size_t>(a)]); });
    list.append<BeginRecord>().mode = m_mode;
    for (std::size_t vertex = 0; vertex < vertices.size(); vertex += stride) {
        const auto value_at = [&](std::size_t offset) {
            Value value;
            std::copy_n(vertices.begin() + static_cast<std::ptrdiff_t>(vertex + offset), 4, value.begin());
            return value;
        };
        for (std::size_t s = 0; s < streams.size(); ++s) record_call(list, streams[s], value_at(4 * (s + 1)));
        record_call(list, pipeline::kPosition, value_at(0));
    }
    for_each_bit(set, [&](int a) { record_call(list, a, last[static_cast<std::size_t>(a)]); });
}

void ListVertices::record_batch(DisplayList& list) {
    PrimitivesRecord record{};
    const auto add_stream = [&](std::uint8_t attribute, std::uint32_t index) {
        const std::uint8_t components = needed_components(m_data.data() + 4 * index, m_count, m_stride);
        record.streams[record.stream_count++] = {attribute, components,
                                                 static_cast<std::uint16_t>(record.stride)};
        record.stride += components * static_cast<std::uint32_t>(sizeof(float));
    };
    add_stream(pipeline::kPosition, 0);
    for (std::uint32_t s = 0; s < m_streams.size(); ++s) add_stream(m_streams[s], s + 1);

    record.run_count = static_cast<std::uint32_t>(m_runs.size());
    record.before_count = static_cast<std::uint32_t>(std::popcount(m_constant));
    record.after_count = static_cast<std::uint32_t>(std::popcount(m_set));
    record.vertex_count = m_count;
    record.index_set = m_index_set;
    record.index = m_index;

    const std::size_t bytes = record.run_count * sizeof(PrimitiveRun) +
                              (record.before_count + record.after_count) * sizeof(AttributeValue) +
                              std::size_t{m_count} * record.stride;
    auto& made = list.append<PrimitivesRecord>(bytes);
    record.header = made.header;
    made = record;
    auto* runs = reinterpret_cast<PrimitiveRun*>(&made + 1);
    auto* values = reinterpret_cast<AttributeValue*>(std::copy(m_runs.begin(), m_runs.end(), runs));
    values = store_values(values, m_constant, m_first);
    values = store_values(values, m_set, m_last);
    auto* out = reinterpret_cast<float*>(values);
    for (std::uint32_t i = 0; i < m_count; ++i) {
        const float* vertex = m_data.data() + std::size_t{i} * m_stride;
        for (std::uint32_t s = 0; s < record.stream_count; ++s)
            out = std::copy_n(vertex + 4 * s, record.streams[s].components, out);
    }
}

template <typename Collect>
void collect(Context& ctx, Collect collect_one) noexcept {
    if (ctx.lists.out_of_memory) return;
    try {
        collect_one(ctx.lists.vertices, *ctx.lists.compiling);
    } catch (const std::exception&) {
        list_out_of_memory(ctx);
    }
}

void Compile::Begin(Context& ctx, GLenum mode) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) { vertices.begin(list, mode); });
    if (ctx.lists.execute_too) ctx.dispatch.execute->Begin(&ctx, mode);
}

void Compile::End(Context& ctx) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) { vertices.end(list); });
    if (ctx.lists.execute_too) ctx.dispatch.execute->End(&ctx);
}

void Compile::Vertex4f(Context& ctx, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) { vertices.vertex(list, {x, y, z, w}); });
    if (ctx.lists.execute_too) ctx.dispatch.execute->Vertex4f(&ctx, x, y, z, w);
}

void Compile::Color4f(Context& ctx, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kColor, {red, green, blue, alpha});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->Color4f(&ctx, red, green, blue, alpha);
}

void Compile::Normal3f(Context& ctx, GLfloat nx, GLfloat ny, GLfloat nz) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kNormal, {nx, ny, nz, 1});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->Normal3f(&ctx, nx, ny, nz);
}

void Compile::TexCoord4f(Context& ctx, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kTexture0, {s, t, r, q});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->TexCoord4f(&ctx, s, t, r, q);
}

void Compile::MultiTexCoord4f(Context& ctx, GLenum target, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kTexture0 + static_cast<int>(target & 7), {s, t, r, q});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->MultiTexCoord4f(&ctx, target, s, t, r, q);
}

void Compile::SecondaryColor3f(Context& ctx, GLfloat red, GLfloat green, GLfloat blue) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kSecondaryColor, {red, green, blue, 1});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->SecondaryColor3f(&ctx, red, green, blue);
}

void Compile::FogCoordf(Context& ctx, GLfloat coord) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kFogCoordinate, {coord, 0, 0, 1});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->FogCoordf(&ctx, coord);
}

void Compile::EdgeFlag(Context& ctx, GLboolean flag) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) {
        vertices.attribute(list, pipeline::kEdgeFlag, {flag ? 1.0f : 0.0f, 0, 0, 1});
    });
    if (ctx.lists.execute_too) ctx.dispatch.execute->EdgeFlag(&ctx, flag);
}

void Compile::Indexf(Context& ctx, GLfloat c) {
    collect(ctx, [&](ListVertices& vertices, DisplayList& list) { vertices.index(list, c); });
    if (ctx.lists.execute_too) ctx.dispatch.execute->Indexf(&ctx, c);
}

}  // namespace terrazzo::gl
