// Draws whose pieces go to all threads: the picture is bit by bit the one that the calling thread alone makes
// of the same pieces, which are tiny here, so that every draw has many. TERRAZZO_THREADS says how many
// threads.
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "attach_picture.h"
#include "gl/generated/commands.h"
#include "gl_fixture.h"
#include "random.h"
#include "seed_of_run.h"

namespace terrazzo::gl {
namespace {

using stress::Random;

constexpr int kWidth = 200, kHeight = 150;  // several bins, and parts of bins
constexpr std::uint32_t kNever = UINT32_MAX, kAlways = 1;
constexpr pipeline::PieceSizes kTiny{.indexed = 96, .consecutive = 64, .long_fan = 32};

struct Vertex {
    float color[4], normal[3], position[4];
};

Vertex random_vertex(Random& random) {
    Vertex v{};
    for (float& c : v.color) c = random.between(0, 1);
    for (float& c : v.normal) c = random.between(-1, 1);
    // Some are clipped, and behind the viewer.
    const float reach = random.once_in(4) ? 2.5f : 0.9f;
    for (int i = 0; i < 3; ++i) v.position[i] = random.between(-reach, reach);
    v.position[3] = random.once_in(8) ? random.between(-0.5f, 2) : 1.0f;
    return v;
}

// Triangles of neighbouring vertices are small, most of the time.
std::vector<Vertex> random_vertices(Random& random, int count) {
    std::vector<Vertex> vertices;
    Vertex centre = random_vertex(random);
    for (int i = 0; i < count; ++i) {
        if (random.once_in(12)) centre = random_vertex(random);
        Vertex v = random_vertex(random);
        for (int c = 0; c < 3; ++c) v.position[c] = centre.position[c] + 0.1f * v.position[c];
        v.position[3] = centre.position[3];
        vertices.push_back(v);
    }
    return vertices;
}

void enable_or_not(GLenum what, bool on) {
    on ? glEnable(what) : glDisable(what);
}

void choose_state(Random& random) {
    constexpr GLenum kModes[] = {GL_FILL, GL_FILL, GL_FILL, GL_LINE, GL_POINT};
    glShadeModel(random.once_in(3) ? GL_FLAT : GL_SMOOTH);
    enable_or_not(GL_LIGHTING, random.coin());
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, random.coin());
    const GLfloat back[4] = {random.between(0, 1), random.between(0, 1), 0.2f, 1};
    glMaterialfv(GL_BACK, GL_EMISSION, back);
    glPolygonMode(GL_FRONT, random.one_of(kModes));
    glPolygonMode(GL_BACK, random.one_of(kModes));
    enable_or_not(GL_CULL_FACE, random.once_in(4));
    enable_or_not(GL_POLYGON_OFFSET_FILL, random.once_in(4));
    glPolygonOffset(random.between(-2, 2), 1);
    enable_or_not(GL_LINE_STIPPLE, random.once_in(5));
    glLineStipple(2, 0x3f5a);
    enable_or_not(GL_LINE_SMOOTH, random.once_in(5));
    enable_or_not(GL_POINT_SMOOTH, random.once_in(5));
    glLineWidth(random.between(0.5f, 4));
    glPointSize(random.between(0.5f, 6));
    const GLdouble plane[4] = {1, 0.3, 0, 0.4};
    glClipPlane(GL_CLIP_PLANE0, plane);
    enable_or_not(GL_CLIP_PLANE0, random.once_in(4));
    // Whatever depends on the order of drawing.
    enable_or_not(GL_DEPTH_TEST, random.coin());
    enable_or_not(GL_BLEND, random.coin());
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    enable_or_not(GL_STENCIL_TEST, random.coin());
    glStencilFunc(GL_ALWAYS, random.below(256), 0xff);
    glStencilOp(GL_KEEP, GL_INVERT, GL_REPLACE);
}

void set_pointers(const Vertex* vertices) {
    glVertexPointer(4, GL_FLOAT, sizeof(Vertex), vertices->position);
    glNormalPointer(GL_FLOAT, sizeof(Vertex), vertices->normal);
    glColorPointer(4, GL_FLOAT, sizeof(Vertex), vertices->color);
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY}) glEnableClientState(array);
}

void call_by_call(GLenum mode, const std::vector<Vertex>& vertices) {
    glBegin(mode);
    for (const Vertex& v : vertices) {
        glColor4fv(v.color);
        glNormal3fv(v.normal);
        glVertex4fv(v.position);
    }
    glEnd();
}

// The vertices are gone, or have changed, when it returns.
void draw(Random& random, GLenum mode) {
    const int count = 100 + random.below(900);
    std::vector<Vertex> vertices = random_vertices(random, count);
    switch (random.below(4)) {
        case 0:
            return call_by_call(mode, vertices);
        case 1: {
            const GLuint list = glGenLists(1);
            glNewList(list, GL_COMPILE);
            call_by_call(mode, vertices);
            glEndList();
            glCallList(list);
            glDeleteLists(list, 1);
            return;
        }
        case 2:
            set_pointers(vertices.data());
            glDrawArrays(mode, 3, count - 3);
            break;
        case 3: {
            // Indices near each other, which are shaded once, or all over the place.
            std::vector<GLuint> indices;
            const int near = random.coin() ? 20 : count;
            for (int i = 0; i < count; ++i)
                indices.push_back(static_cast<GLuint>((i / 2 + random.below(near)) % count));
            set_pointers(vertices.data());
            glDrawElements(mode, count, GL_UNSIGNED_INT, indices.data());
            break;
        }
    }
    for (Vertex& v : vertices) v = {};
}

class ParallelDrawTest : public GlTest {
  protected:
    ParallelDrawTest() { attach_picture(ctx(), kWidth, kHeight); }

    struct Picture {
        std::vector<GLubyte> colors, stencils;
        std::vector<GLuint> depths;
        bool operator==(const Picture&) const = default;
    };
    Picture picture() {
        constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;
        Picture out{std::vector<GLubyte>(4 * kPixels), std::vector<GLubyte>(kPixels),
                    std::vector<GLuint>(kPixels)};
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, out.colors.data());
        glReadPixels(0, 0, kWidth, kHeight, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, out.stencils.data());
        glReadPixels(0, 0, kWidth, kHeight, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, out.depths.data());
        EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
        return out;
    }
    void clear() {
        glClearColor(0.1f, 0.2f, 0.3f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    Picture empty() {
        clear();
        return picture();
    }

    // What `commands` draw in tiny pieces.
    template <typename Commands>
    Picture drawn(std::uint32_t worth_waking, Commands commands, const pipeline::PieceSizes& sizes = kTiny) {
        ctx().renderer.set_pieces(sizes, worth_waking);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        clear();
        commands();
        glPopAttrib();
        return picture();
    }
    template <typename Commands>
    void expect_the_same(Commands commands, const pipeline::PieceSizes& sizes = kTiny) {
        const Picture alone = drawn(kNever, commands, sizes);
        EXPECT_FALSE(alone == empty()) << "nothing is drawn";
        EXPECT_TRUE(alone == drawn(kAlways, commands, sizes));
    }
};

TEST_F(ParallelDrawTest, RandomScenesAreTheSame) {
    std::set<std::vector<GLubyte>> pictures;
    constexpr std::uint64_t kSeeds = 60;
    for (std::uint64_t seed = stress::seed_of_run(); seed < stress::seed_of_run() + kSeeds; ++seed) {
        SCOPED_TRACE("TERRAZZO_SHARE_SEED=" + std::to_string(seed));
        const auto scene = [&] {
            Random random(seed);
            for (int i = 0; i < 6; ++i) {
                choose_state(random);
                draw(random, GL_POINTS + static_cast<GLenum>(random.below(GL_POLYGON + 1)));
            }
        };
        const Picture alone = drawn(kNever, scene);
        EXPECT_TRUE(alone == drawn(kAlways, scene));
        pictures.insert(alone.colors);
    }
    EXPECT_GT(pictures.size(), kSeeds * 3 / 4);
}

TEST_F(ParallelDrawTest, EveryKindOfPrimitiveIsTheSame) {
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        for (const bool flat : {false, true}) {
            SCOPED_TRACE("mode " + std::to_string(mode) + (flat ? ", flat" : ""));
            expect_the_same([&] {
                Random random(mode);
                glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
                for (int i = 0; i < 4; ++i) draw(random, mode);
            });
        }
    }
}

// Pieces in their usual sizes, and more of them than wait for each other.
TEST_F(ParallelDrawTest, LongDrawsAreTheSame) {
    Random random(5);
    const std::vector<Vertex> vertices = random_vertices(random, 3 * 4096 + 100);
    const auto arrays = [&] {
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        set_pointers(vertices.data());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<GLsizei>(vertices.size()));
    };
    expect_the_same(arrays, {});
    expect_the_same(arrays);
}

// The frame is drawn before the draw is over, with threads at work.
TEST_F(ParallelDrawTest, DrawsLargerThanAFrameAreTheSame) {
    Random random(6);
    const std::vector<Vertex> vertices = random_vertices(random, 300);
    std::vector<GLuint> indices;
    for (int i = 0; i < 3 * 500000; ++i) indices.push_back(static_cast<GLuint>(random.below(300)));
    expect_the_same(
        [&] {
            glEnable(GL_SCISSOR_TEST);
            glScissor(20, 20, 8, 8);
            glEnable(GL_BLEND);
            glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            set_pointers(vertices.data());
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT,
                           indices.data());
        },
        {});
}

TEST_F(ParallelDrawTest, BuffersMayChangeAfterwards) {
    Random random(7);
    const std::vector<Vertex> vertices = random_vertices(random, 1000), none(1000);
    const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex));
    expect_the_same([&] {
        GLuint buffer = 0;
        gen_buffers(ctx(), 1, &buffer);
        bind_buffer(ctx(), GL_ARRAY_BUFFER, buffer);
        buffer_data(ctx(), GL_ARRAY_BUFFER, bytes, vertices.data(), GL_STATIC_DRAW);
        glVertexPointer(4, GL_FLOAT, sizeof(Vertex),
                        reinterpret_cast<const void*>(offsetof(Vertex, position)));
        glColorPointer(4, GL_FLOAT, sizeof(Vertex), nullptr);
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_COLOR_ARRAY);
        glDisableClientState(GL_NORMAL_ARRAY);
        glDrawArrays(GL_TRIANGLES, 0, 999);
        buffer_sub_data(ctx(), GL_ARRAY_BUFFER, 0, bytes, none.data());
        delete_buffers(ctx(), 1, &buffer);
    });
}

TEST_F(ParallelDrawTest, QueriesCountTheSameSamples) {
    GLuint counts[2] = {};
    for (const std::uint32_t worth_waking : {kNever, kAlways}) {
        GLuint query = 0;
        gen_queries(ctx(), 1, &query);
        drawn(worth_waking, [&] {
            Random random(8);
            glEnable(GL_DEPTH_TEST);
            begin_query(ctx(), GL_SAMPLES_PASSED, query);
            draw(random, GL_TRIANGLES);
            draw(random, GL_TRIANGLE_STRIP);
            end_query(ctx(), GL_SAMPLES_PASSED);
        });
        get_query_objectuiv(ctx(), query, GL_QUERY_RESULT, &counts[worth_waking == kAlways]);
        delete_queries(ctx(), 1, &query);
    }
    EXPECT_GT(counts[0], 100u);
    EXPECT_EQ(counts[0], counts[1]);
}

TEST_F(ParallelDrawTest, FeedbackComesInOrder) {
    std::vector<GLfloat> values[2];
    for (const std::uint32_t worth_waking : {kNever, kAlways}) {
        std::vector<GLfloat>& out = values[worth_waking == kAlways];
        out.assign(100000, 0);
        glFeedbackBuffer(static_cast<GLsizei>(out.size()), GL_3D_COLOR, out.data());
        drawn(worth_waking, [&] {
            Random random(9);
            glRenderMode(GL_FEEDBACK);
            draw(random, GL_TRIANGLES);
            EXPECT_GT(glRenderMode(GL_RENDER), 500);
        });
    }
    EXPECT_EQ(values[0], values[1]);
}

}  // namespace
}  // namespace terrazzo::gl
