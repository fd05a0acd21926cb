// Objects that contexts share, changed in one thread while others use them: buffers, textures, renderbuffers
// and display lists, their names, and contexts that come and go.
//
// What a test changes is always one value all over, put in place by one command: whoever uses it sees the
// value of before or of after, and never a mixture. Without a sanitizer that is what fails; the thread
// sanitizer, under which this runs in ./check, finds what memory's order happened to hide.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "attach_picture.h"
#include "gl/context.h"
#include "random.h"
#include "seed_of_run.h"

namespace terrazzo::gl {
namespace {

constexpr int kSize = 16;
constexpr int kRounds = 2000;

using stress::Random;
using stress::seed_of_run;

// A context of its own, current in the calling thread, with a small picture.
class CurrentContext {
  public:
    explicit CurrentContext(Context* partner, int size = kSize)
        : m_context(create_context(Config{}, partner)) {
        attach_picture(*m_context, size, size);
        make_current(m_context.get());
    }
    ~CurrentContext() { make_current(nullptr); }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

  private:
    std::unique_ptr<Context> m_context;
};

template <typename Value>
bool all_alike(const std::vector<Value>& values) {
    return std::all_of(values.begin(), values.end(), [&](Value v) { return v == values.front(); });
}

std::vector<GLubyte> read_picture(int size = kSize) {
    std::vector<GLubyte> pixels(static_cast<std::size_t>(4 * size * size));
    glReadPixels(0, 0, size, size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

void draw_square() {
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        glTexCoord2i(x, y);
        glVertex2i(2 * x - 1, 2 * y - 1);
    }
    glEnd();
}

// Contexts that share nothing but the worker threads, which the first drawing starts. This comes first in the
// process, before any other has drawn.
TEST(WorkerThreads, AreStartedByContextsOfSeveralThreads) {
    constexpr int kLarge = 512, kThreads = 4;
    std::atomic<int> waiting = kThreads;
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) {
        threads.emplace_back([&] {
            const CurrentContext current(nullptr, kLarge);
            --waiting;
            while (waiting != 0) std::this_thread::yield();
            glClearColor(1, 1, 1, 1);
            glClear(GL_COLOR_BUFFER_BIT);
            draw_square();
            EXPECT_TRUE(all_alike(read_picture(kLarge)));
        });
    }
    for (std::thread& thread : threads) thread.join();
}

class ShareGroups : public testing::Test {
  protected:
    ShareGroups() : m_partner(create_context(Config{}, nullptr)) { make_current(m_partner.get()); }
    ~ShareGroups() override { make_current(nullptr); }

    // Each body is called `kRounds` times in a thread and a context of its own, all at the same time.
    using Body = std::function<void(Random&)>;
    void run(const std::vector<Body>& bodies) {
        std::atomic<std::size_t> waiting = bodies.size();
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            threads.emplace_back([&, i] {
                const CurrentContext current(m_partner.get());
                Random random(seed_of_run() + i);
                --waiting;
                while (waiting != 0) std::this_thread::yield();
                for (int round = 0; round < kRounds; ++round) bodies[i](random);
                EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "thread " << i;
            });
        }
        for (std::thread& thread : threads) thread.join();
    }

    std::unique_ptr<Context> m_partner;
};

TEST_F(ShareGroups, BuffersGetNewStores) {
    constexpr GLuint kBytes = 1, kVertices = 2;
    const auto specify_bytes = [](Random& random) {
        const std::vector<GLubyte> bytes(static_cast<std::size_t>(1024 << random.below(3)), random.byte());
        glBindBuffer(GL_ARRAY_BUFFER, kBytes);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
    };
    // A square over the whole picture, in some colour.
    const auto specify_vertices = [](Random& random) {
        const GLfloat c = random.between(0, 1);
        const std::array<GLfloat, 20> square = {c, c, c, -1, -1, c, c, c, 1,  -1,
                                                c, c, c, 1,  1,  c, c, c, -1, 1};
        glBindBuffer(GL_ARRAY_BUFFER, kVertices);
        glBufferData(GL_ARRAY_BUFFER, sizeof square, square.data(), GL_STREAM_DRAW);
    };
    for (Random random(1); const auto& specify : {Body(specify_bytes), Body(specify_vertices)})
        specify(random);

    const auto read_back = [](Random&) {
        std::vector<GLubyte> bytes(1024);
        glBindBuffer(GL_ARRAY_BUFFER, kBytes);
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, 1024, bytes.data());
        EXPECT_TRUE(all_alike(bytes));
        GLint size = 0;
        glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
        EXPECT_GE(size, 1024);
    };
    const auto draw_pixels = [](Random&) {
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, kBytes);
        glWindowPos2i(0, 0);
        glDrawPixels(kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
        EXPECT_TRUE(all_alike(read_picture()));
    };
    const auto draw_arrays = [](Random& random) {
        glBindBuffer(GL_ARRAY_BUFFER, kVertices);
        glInterleavedArrays(GL_C3F_V3F, 20, nullptr);
        glVertexPointer(2, GL_FLOAT, 20, reinterpret_cast<const void*>(12));
        if (random.coin()) {
            glDrawArrays(GL_QUADS, 0, 4);
        } else {
            const GLuint list = glGenLists(1);
            glNewList(list, GL_COMPILE);
            glDrawArrays(GL_QUADS, 0, 4);
            glEndList();
            glCallList(list);
            glDeleteLists(list, 1);
        }
        std::vector<GLubyte> pixels = read_picture();
        for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = pixels[0];
        EXPECT_TRUE(all_alike(pixels));
    };
    run({specify_bytes, specify_bytes, specify_vertices, read_back, draw_pixels, draw_arrays});
}

// Every command that takes pixels from a buffer or puts them there keeps the store it began with.
TEST_F(ShareGroups, PixelsAreInStoresThatAreReplaced) {
    constexpr GLuint kUnpacked = 1, kPacked = 2;
    constexpr GLsizeiptr kBytes = 4096;  // more than any of them needs
    const auto replace = [](GLenum target, GLuint name, Random& random) {
        glBindBuffer(target, name);
        glBufferData(target, kBytes << random.below(2), nullptr, GL_STREAM_DRAW);
        glBindBuffer(target, 0);
    };
    const auto replace_unpacked = [&](Random& random) { replace(GL_PIXEL_UNPACK_BUFFER, kUnpacked, random); };
    const auto replace_packed = [&](Random& random) { replace(GL_PIXEL_PACK_BUFFER, kPacked, random); };
    const auto unpack = [](Random&) {
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, kUnpacked);
        glPolygonStipple(nullptr);
        glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 256, nullptr);
        glPixelMapuiv(GL_PIXEL_MAP_G_TO_G, 256, nullptr);
        glPixelMapusv(GL_PIXEL_MAP_B_TO_B, 256, nullptr);
        glWindowPos2i(0, 0);
        glBitmap(kSize, kSize, 0, 0, 0, 0, nullptr);
        glDrawPixels(kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, 16, 0, 256, nullptr);
        glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 256,
                                  nullptr);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    };
    const auto pack = [](Random&) {
        glBindBuffer(GL_PIXEL_PACK_BUFFER, kPacked);
        glGetPolygonStipple(nullptr);
        glGetPixelMapfv(GL_PIXEL_MAP_R_TO_R, nullptr);
        glGetPixelMapuiv(GL_PIXEL_MAP_G_TO_G, nullptr);
        glGetPixelMapusv(GL_PIXEL_MAP_B_TO_B, nullptr);
        glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glBindTexture(GL_TEXTURE_2D, 7);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glGetCompressedTexImage(GL_TEXTURE_2D, 0, nullptr);
        glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    };
    Random random(1);
    replace_unpacked(random);
    replace_packed(random);
    run({replace_unpacked, replace_packed, unpack, pack});
}

// The two write to the store at the same time in the only way that makes sense: one replaces it.
TEST_F(ShareGroups, BuffersAreWrittenInPartsWhileTheyGetNewStores) {
    glBindBuffer(GL_ARRAY_BUFFER, 1);
    glBufferData(GL_ARRAY_BUFFER, 4096, nullptr, GL_STREAM_DRAW);
    const auto specify = [](Random& random) {
        glBindBuffer(GL_ARRAY_BUFFER, 1);
        glBufferData(GL_ARRAY_BUFFER, 4096 << random.below(2), nullptr, GL_STREAM_DRAW);
    };
    const auto write_part = [](Random& random) {
        const std::vector<GLubyte> bytes(4096, random.byte());
        glBindBuffer(GL_ARRAY_BUFFER, 1);
        glBufferSubData(GL_ARRAY_BUFFER, 0, 4096, bytes.data());
    };
    run({specify, write_part, specify});
}

TEST_F(ShareGroups, NamesComeAndGo) {
    const auto buffers = [](Random& random) {
        std::array<GLuint, 3> names{};
        glGenBuffers(3, names.data());
        for (const GLuint name : names) {
            glBindBuffer(GL_ARRAY_BUFFER, name);
            glBufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
            glVertexPointer(2, GL_FLOAT, 0, nullptr);
            EXPECT_TRUE(glIsBuffer(name));
        }
        glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
        glIsBuffer(static_cast<GLuint>(1 + random.below(20)));
        glDeleteBuffers(3, names.data());
        glPopClientAttrib();
    };
    const auto textures = [](Random& random) {
        std::array<GLuint, 3> names{};
        glGenTextures(3, names.data());
        for (const GLuint name : names) glBindTexture(GL_TEXTURE_2D, name);
        glPushAttrib(GL_TEXTURE_BIT);
        glIsTexture(static_cast<GLuint>(1 + random.below(20)));
        glDeleteTextures(3, names.data());
        glPopAttrib();
    };
    const auto renderbuffers = [](Random& random) {
        std::array<GLuint, 3> names{};
        glGenRenderbuffers(3, names.data());
        for (const GLuint name : names) glBindRenderbuffer(GL_RENDERBUFFER, name);
        glIsRenderbuffer(static_cast<GLuint>(1 + random.below(20)));
        glDeleteRenderbuffers(3, names.data());
    };
    const auto lists = [](Random& random) {
        const GLuint first = glGenLists(3);
        glNewList(first + 1, GL_COMPILE);
        glColor3f(1, 0, 0);
        glEndList();
        glCallList(static_cast<GLuint>(1 + random.below(20)));
        glIsList(first);
        glDeleteLists(first, 3);
    };
    const auto contexts = [this](Random& random) {
        if (!random.once_in(10)) return;
        const auto another = create_context(Config{}, m_partner.get());
    };
    // Every other command that looks a name up, which may be there or not.
    const auto lookups = [](Random& random) {
        const auto name = [&] { return static_cast<GLuint>(1 + random.below(20)); };
        const GLuint names[2] = {name(), name()};
        const GLclampf priorities[2] = {0.25f, 0.75f};
        GLboolean resident[2];
        glAreTexturesResident(2, names, resident);
        glPrioritizeTextures(2, names, priorities);
        glCallLists(2, GL_UNSIGNED_INT, names);
        glBindFramebuffer(GL_FRAMEBUFFER, 1);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name());
        glFramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, name(), 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name(), 0);
        glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, name(), 0, 0);
        glCheckFramebufferStatus(GL_FRAMEBUFFER);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        while (glGetError() != GL_NO_ERROR) continue;
    };
    run({buffers, buffers, textures, textures, renderbuffers, renderbuffers, lists, lists, contexts,
         lookups});
}

// One name each for whom binding looks at what the others delete.
TEST_F(ShareGroups, ANameIsBoundWhileItIsDeleted) {
    static constexpr GLuint kName = 7;
    const auto binds = [](GLenum target) {
        return [target](Random&) {
            for (int i = 0; i < 20; ++i) {
                glBindTexture(target, kName);
                glBindBuffer(GL_ARRAY_BUFFER, kName);
                glBindRenderbuffer(GL_RENDERBUFFER, kName);
                glGetError();  // another target's, once in a while
            }
        };
    };
    const auto deletes = [](Random&) {
        for (int i = 0; i < 20; ++i) {
            glBindTexture(GL_TEXTURE_2D, kName);
            glDeleteTextures(1, &kName);
            glDeleteBuffers(1, &kName);
            glDeleteRenderbuffers(1, &kName);
            glGetError();
        }
    };
    run({binds(GL_TEXTURE_1D), binds(GL_TEXTURE_3D), deletes, deletes});
}

TEST_F(ShareGroups, TexturesGetNewImages) {
    constexpr GLuint kTexture = 1, kMipmapped = 2;
    const auto specify = [](GLuint texture) {
        return [texture](Random& random) {
            const int size = texture == kMipmapped ? 8 : 4 << random.below(2);
            const std::vector<GLubyte> texels(static_cast<std::size_t>(3 * size * size), random.byte());
            glBindTexture(GL_TEXTURE_2D, texture);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
            if (texture == kMipmapped) glGenerateMipmap(GL_TEXTURE_2D);
            glFinish();
        };
    };
    const auto replace_texels = [](Random& random) {
        const std::vector<GLubyte> texels(3 * 8 * 8, random.byte());
        glBindTexture(GL_TEXTURE_2D, kMipmapped);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
        const GLint filter = random.coin() ? GL_NEAREST : GL_LINEAR;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    };
    const auto copy_picture = [](Random& random) {
        const GLfloat c = random.between(0, 1);
        glClearColor(c, c, c, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glBindTexture(GL_TEXTURE_2D, kMipmapped);
        if (random.coin()) {
            glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 8, 8, 0);
        } else {
            glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8);
        }
    };
    const auto draw = [](GLuint texture) {
        return [texture](Random&) {
            glEnable(GL_TEXTURE_2D);
            glBindTexture(GL_TEXTURE_2D, texture);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            draw_square();
            std::vector<GLubyte> pixels = read_picture();
            for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = pixels[0];
            EXPECT_TRUE(all_alike(pixels));
        };
    };
    const auto query = [](Random& random) {
        glBindTexture(GL_TEXTURE_2D, random.coin() ? kTexture : kMipmapped);
        std::vector<GLubyte> texels(16 * 16 * 3);
        GLint width = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        EXPECT_TRUE(width == 4 || width == 8);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
        const std::vector<GLubyte> whole(texels.begin(), texels.begin() + 4 * 4 * 3);
        EXPECT_TRUE(all_alike(whole));
        GLint filter = 0;
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, &filter);
        EXPECT_TRUE(filter == GL_NEAREST || filter == GL_LINEAR);
    };
    Random random(1);
    for (const GLuint texture : {kTexture, kMipmapped}) specify(texture)(random);
    glBindTexture(GL_TEXTURE_2D, 0);
    run({specify(kTexture), specify(kTexture), specify(kMipmapped), replace_texels, copy_picture,
         draw(kTexture), draw(kMipmapped), query});
}

// Depths stay where they were drawn, and textures are sampled there, by whoever shares them.
TEST_F(ShareGroups, DrawnDepthsAreSampled) {
    constexpr GLuint kTexture = 1;
    constexpr int kMapSize = 80;  // several bins, not all of them whole
    const auto specify = [](Random& random) {
        const std::vector<GLfloat> depths(kMapSize * kMapSize, random.between(0, 1));
        glBindTexture(GL_TEXTURE_2D, kTexture);
        if (random.coin()) {
            glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kMapSize, kMapSize, 0, GL_DEPTH_COMPONENT,
                         GL_FLOAT, depths.data());
        } else {
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kMapSize, kMapSize, GL_DEPTH_COMPONENT, GL_FLOAT,
                            depths.data());
        }
    };
    const auto draw_to = [](Random& random) {
        glBindFramebuffer(GL_FRAMEBUFFER, 1);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, kTexture, 0);
        glViewport(0, 0, kMapSize, kMapSize);
        glClearDepth(random.between(0, 1));
        glClear(GL_DEPTH_BUFFER_BIT);
        if (random.coin()) {
            glEnable(GL_DEPTH_TEST);
            glDepthFunc(GL_ALWAYS);
            draw_square();
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    };
    const auto sample = [](Random& random) {
        glEnable(GL_TEXTURE_2D);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glBindTexture(GL_TEXTURE_2D, kTexture);
        const GLint filter = random.coin() ? GL_NEAREST : GL_LINEAR;
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        draw_square();
        std::vector<GLubyte> pixels = read_picture();
        for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = pixels[0];
        EXPECT_TRUE(all_alike(pixels));
    };
    const auto query = [](Random&) {
        std::vector<GLfloat> depths(kMapSize * kMapSize);
        glBindTexture(GL_TEXTURE_2D, kTexture);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        EXPECT_TRUE(all_alike(depths));
    };
    glBindTexture(GL_TEXTURE_2D, kTexture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kMapSize, kMapSize, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
    run({specify, draw_to, draw_to, sample, sample, query});
}

// Frame buffer objects are their context's own, what is attached to them is not.
TEST_F(ShareGroups, AttachedImagesChange) {
    constexpr GLuint kTexture = 1, kColor = 1, kDepth = 2;
    const auto specify_texture = [](Random& random) {
        const int size = 8 << random.below(2);
        glBindTexture(GL_TEXTURE_2D, kTexture);
        const bool none = random.once_in(8);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, none ? 0 : size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    };
    const auto specify_renderbuffers = [](Random& random) {
        const int size = random.once_in(8) ? 0 : 8 << random.below(2);
        const GLenum colors[] = {GL_RGBA8, GL_RGB565, GL_RGBA16},
                     depths[] = {GL_DEPTH_COMPONENT16, GL_DEPTH24_STENCIL8};
        const GLsizei samples = random.coin() ? 4 : 0;
        glBindRenderbuffer(GL_RENDERBUFFER, kColor);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, random.one_of(colors), size, size);
        glBindRenderbuffer(GL_RENDERBUFFER, kDepth);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, random.one_of(depths), size, size);
    };
    const auto query = [](Random& random) {
        glBindRenderbuffer(GL_RENDERBUFFER, random.coin() ? kColor : kDepth);
        for (int times = 0; times < 8; ++times) {
            GLint width = -1, bits = -1, samples = -1;
            glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &width);
            glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_RED_SIZE, &bits);
            glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples);
            EXPECT_TRUE(width == 0 || width == 8 || width == 16) << width;
            EXPECT_TRUE(bits == 0 || bits == 5 || bits == 8 || bits == 16) << bits;
            EXPECT_TRUE(samples == 0 || samples == 4) << samples;
        }
    };
    // Draws whether the object is complete or not: GL_INVALID_FRAMEBUFFER_OPERATION comes and goes.
    const auto draw_to_object = [](Random& random) {
        const GLfloat c = random.between(0, 1);
        glClearColor(c, c, c, c);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_square();
        GLint value = -1;
        glGetIntegerv(GL_SAMPLES, &value);
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                              GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, &value);
        glCheckFramebufferStatus(GL_FRAMEBUFFER);
        glFinish();
        const GLenum error = glGetError();
        EXPECT_TRUE(error == GL_NO_ERROR || error == GL_INVALID_FRAMEBUFFER_OPERATION) << error;
    };
    const auto to_texture = [&](Random& random) {
        glBindFramebuffer(GL_FRAMEBUFFER, 1);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, kTexture, 0);
        draw_to_object(random);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glGetError();  // of what has been drawn when the object is left
    };
    const auto to_renderbuffers = [&](Random& random) {
        glBindFramebuffer(GL_FRAMEBUFFER, 2);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, kColor);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, kDepth);
        draw_to_object(random);
    };
    Random random(1);
    specify_texture(random);
    specify_renderbuffers(random);
    glBindTexture(GL_TEXTURE_2D, 0);
    run({specify_texture, specify_renderbuffers, query, to_texture, to_renderbuffers});
}

TEST_F(ShareGroups, ListsAreReplacedAndDeleted) {
    constexpr GLuint kSquare = 1, kCaller = 2;
    const auto compile = [](Random& random) {
        const GLfloat c = random.between(0, 1);
        glNewList(kSquare, GL_COMPILE);
        glColor4f(c, c, c, c);
        draw_square();
        glEndList();
    };
    const auto compile_caller = [](Random& random) {
        glNewList(kCaller, random.coin() ? GL_COMPILE : GL_COMPILE_AND_EXECUTE);
        glCallList(kSquare);
        glEndList();
    };
    const auto remove = [](Random& random) {
        if (random.once_in(10)) glDeleteLists(kSquare, 2);
    };
    const auto call = [](Random& random) {
        glCallList(random.coin() ? kSquare : kCaller);
        EXPECT_TRUE(all_alike(read_picture()));
        EXPECT_EQ(glIsList(3), GL_FALSE);
    };
    Random random(1);
    compile(random);
    run({compile, compile, compile_caller, remove, call, call});
}

}  // namespace
}  // namespace terrazzo::gl
