// The operations of an episode; see operations.h.
#include "fuzz/operations.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fuzz/arguments.h"
#include "state_dump.h"

namespace terrazzo::fuzz {
namespace {

const Command& any_command(Session& session, Random& random) {
    const auto& families = session.library.families;
    const auto& family = families[random.below(static_cast<unsigned>(families.size()))];
    return *family[random.below(static_cast<unsigned>(family.size()))];
}

void any_call(Session& session, Random& random) {
    session.call(any_command(session, random), random);
}

void unknown_call(Session& session, Random& random) {
    const auto& names = session.library.not_implemented;
    if (!names.empty()) session.call(*names[random.below(static_cast<unsigned>(names.size()))], random);
}

// What is legal between Begin and End.
void vertex_call(Session& session, Random& random) {
    static constexpr const char* kNames[] = {
        "glVertex2f",         "glVertex3f",     "glVertex3f",    "glVertex4f",        "glVertex2s",
        "glVertex3dv",        "glColor4f",      "glColor3ub",    "glColor4ubv",       "glNormal3f",
        "glNormal3b",         "glTexCoord2f",   "glTexCoord4f",  "glMultiTexCoord2f", "glMultiTexCoord4fv",
        "glSecondaryColor3f", "glFogCoordf",    "glEdgeFlag",    "glMaterialfv",      "glMaterialf",
        "glIndexi",           "glArrayElement", "glEvalCoord1f", "glEvalCoord2f",     "glEvalPoint1",
        "glCallList"};
    session.call(find_command(random.one_of(kNames)), random);
}

void primitive(Session& session, Random& random) {
    session.call_with("glBegin", random, {static_cast<double>(random.below(10))});
    for (int count = random.one_in(10) ? random.between(0, 90) : random.between(0, 12); count > 0; --count)
        vertex_call(session, random);
    if (!random.one_in(40)) session.call_with("glEnd", random, {});
}

// Ends whatever may have been begun.
void balance(Session& session, Random& random) {
    static constexpr const char* kNames[] = {"glEnd",       "glEnd",       "glEndList",
                                             "glEndList",   "glPopAttrib", "glPopClientAttrib",
                                             "glPopMatrix", "glPopName"};
    if (!random.one_in(4)) return session.call_with(random.one_of(kNames), random, {});
    switch (random.below(4)) {
        case 0:
            return session.call_with("glRenderMode", random, {GL_RENDER});
        case 1:
            return session.call_with("glEndQuery", random, {GL_SAMPLES_PASSED});
        case 2:
            return session.call_with(
                "glUnmapBuffer", random,
                {static_cast<double>(random.of({GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER,
                                                GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER}))});
        default:
            return session.call_with("glBindFramebuffer", random, {GL_FRAMEBUFFER, 0});
    }
}

// Values with which pictures come out, so that what follows is not refused for ever.
void settle(Session& session, Random& random) {
    const auto store = [&](GLenum pname, int value) {
        session.call_with("glPixelStorei", random, {static_cast<double>(pname), static_cast<double>(value)});
    };
    switch (random.below(5)) {
        case 0:
            for (const GLenum pname : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS,
                                       GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES})
                store(pname, 0);
            return;
        case 1:
            for (const GLenum pname : {GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_ROWS,
                                       GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES})
                store(pname, 0);
            return;
        case 2:
            session.call_with("glViewport", random, {0, 0, 64, 64});
            session.call_with("glMatrixMode", random, {GL_PROJECTION});
            session.call_with("glLoadIdentity", random, {});
            session.call_with("glMatrixMode", random, {GL_MODELVIEW});
            return session.call_with("glLoadIdentity", random, {});
        case 3:
            for (const GLenum target :
                 {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER})
                session.call_with("glBindBuffer", random, {static_cast<double>(target), 0});
            return;
        default:
            session.call_with("glPixelZoom", random, {1, 1});
            session.call_with("glRasterPos2f", random, {random.between(-9, 9) / 10.0, 0});
            session.call_with("glDisable", random, {GL_SCISSOR_TEST});
            return session.call_with("glDepthMask", random, {1});
    }
}

void texture(Session& session, Random& random) {
    const auto target =
        random.of<GLenum>({GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_3D});
    const double size = 1 << random.below(6),
                 format = random.of<GLenum>({GL_RGBA, GL_RGB, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_RGB5_A1,
                                             GL_COMPRESSED_RGBA_S3TC_DXT5_EXT});
    const auto parameter = [&](GLenum pname, GLenum value) {
        session.call_with(
            "glTexParameteri", random,
            {static_cast<double>(target), static_cast<double>(pname), static_cast<double>(value)});
    };
    session.call_with("glBindTexture", random,
                      {static_cast<double>(target), static_cast<double>(draw_name(random))});
    if (random.one_in(2))
        parameter(GL_GENERATE_MIPMAP, 1);
    else
        parameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    const int faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
    for (int face = 0; face < faces; ++face) {
        const double at =
            target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : static_cast<int>(target);
        if (target == GL_TEXTURE_1D)
            session.call_with("glTexImage1D", random, {at, 0, format, size, 0, GL_RGBA, GL_UNSIGNED_BYTE});
        else if (target == GL_TEXTURE_3D)
            session.call_with("glTexImage3D", random, {at, 0, format, size, size, 4, 0, GL_RGBA, GL_FLOAT});
        else
            session.call_with("glTexImage2D", random,
                              {at, 0, format, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE});
    }
    session.call_with("glEnable", random, {static_cast<double>(target)});
}

// A frame buffer object with images that fit each other, most of the time.
void framebuffer(Session& session, Random& random) {
    const double width = random.between(1, 70), height = random.between(1, 70),
                 samples = random.one_in(4) ? 4 : 0, name = random.between(1, 6);
    session.call_with("glBindFramebuffer", random,
                      {static_cast<double>(random.of(
                           {GL_FRAMEBUFFER, GL_FRAMEBUFFER, GL_READ_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER})),
                       name});
    const auto image = [&](GLenum attachment, GLenum format) {
        const double renderbuffer = draw_name(random);
        session.call_with("glBindRenderbuffer", random, {GL_RENDERBUFFER, renderbuffer});
        session.call_with("glRenderbufferStorageMultisample", random,
                          {GL_RENDERBUFFER, samples, static_cast<double>(format), width, height});
        session.call_with("glFramebufferRenderbuffer", random,
                          {GL_FRAMEBUFFER, static_cast<double>(attachment), GL_RENDERBUFFER, renderbuffer});
    };
    if (random.one_in(2)) {
        image(GL_COLOR_ATTACHMENT0, random.of<GLenum>({GL_RGBA8, GL_RGB8, GL_RGB5_A1, GL_RGBA16, GL_RGBA4}));
    } else {
        const double texture = draw_name(random);
        session.call_with("glBindTexture", random, {GL_TEXTURE_2D, texture});
        session.call_with("glTexImage2D", random,
                          {GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE});
        session.call_with("glFramebufferTexture2D", random,
                          {GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0});
    }
    if (random.one_in(2))
        image(random.one_in(2) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
              random.of<GLenum>({GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24}));
    session.call_with("glCheckFramebufferStatus", random, {GL_FRAMEBUFFER});
}

void buffer(Session& session, Random& random) {
    const double target = random.of<GLenum>(
        {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER});
    session.call_with("glBindBuffer", random, {target, static_cast<double>(draw_name(random))});
    session.call_with("glBufferData", random,
                      {target, static_cast<double>(random.between(0, 5000)), 0, GL_STATIC_DRAW});
    if (random.one_in(2)) session.call(find_command("glBindBuffer"), random);
}

void arrays(Session& session, Random& random) {
    const double types[] = {GL_FLOAT, GL_SHORT, GL_DOUBLE, GL_INT};
    session.call_with("glVertexPointer", random,
                      {static_cast<double>(random.between(2, 4)), random.one_of(types),
                       static_cast<double>(random.one_in(2) ? 0 : random.between(4, 48))});
    session.call_with("glEnableClientState", random, {GL_VERTEX_ARRAY});
    if (random.one_in(2))
        session.call(
            find_command(random.of({"glColorPointer", "glNormalPointer", "glTexCoordPointer",
                                    "glSecondaryColorPointer", "glEdgeFlagPointer", "glIndexPointer"})),
            random);
    session.call(find_command("glEnableClientState"), random);
    for (int count = random.between(1, 4); count > 0; --count)
        session.call(find_command(random.of({"glDrawArrays", "glDrawElements", "glDrawRangeElements",
                                             "glMultiDrawArrays", "glMultiDrawElements", "glArrayElement"})),
                     random);
}

void list(Session& session, Random& random) {
    const double name = random.between(1, static_cast<int>(kNames));
    session.call_with("glNewList", random,
                      {name, static_cast<double>(random.of({GL_COMPILE, GL_COMPILE_AND_EXECUTE}))});
    for (int count = random.between(0, 12); count > 0; --count)
        random.one_in(4) ? primitive(session, random) : any_call(session, random);
    session.call_with("glEndList", random, {});
    session.call_with("glCallList", random, {name});
}

void pixels(Session& session, Random& random) {
    static constexpr const char* kNames[] = {"glDrawPixels",
                                             "glReadPixels",
                                             "glCopyPixels",
                                             "glBitmap",
                                             "glTexSubImage2D",
                                             "glCopyTexSubImage2D",
                                             "glGetTexImage",
                                             "glBlitFramebuffer",
                                             "glCopyTexImage2D",
                                             "glAccum",
                                             "glClear",
                                             "glTexSubImage3D",
                                             "glCompressedTexSubImage2D",
                                             "glGetCompressedTexImage"};
    session.call(find_command(random.one_of(kNames)), random);
}

// A mapped buffer belongs to the program, as many bytes as it has.
void touch_mapped(Session& session, Random& random) {
    const auto target = random.of<GLenum>(
        {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER});
    if (session.options.shared || !session.answers()) return;
    session.call_with("glMapBuffer", random, {static_cast<double>(target), GL_READ_WRITE});
    void* memory = nullptr;
    GLint size = 0;
    session.gl.GetBufferPointerv(target, GL_BUFFER_MAP_POINTER, &memory);
    session.gl.GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
    if (memory && size > 0)
        std::memset(memory, static_cast<int>(random.below(256)), static_cast<std::size_t>(size));
    if (random.one_in(4)) any_call(session, random);
    if (!random.one_in(8)) session.call_with("glUnmapBuffer", random, {static_cast<double>(target)});
}

// An error changes nothing: every state that can be asked for is as before.
void check_refusal(Session& session, Random& random) {
    if (session.options.shared || !session.model() || !session.answers() || session.model()->list != 0)
        return;
    const Command& command = any_command(session, random);
    if (command.family.starts_with("glCallList")) return;  // many calls, each with an error of its own
    for (int left = 8; left > 0 && session.gl.GetError() != GL_NO_ERROR; --left) continue;
    // A buffer that is deleted does not come back with what a dump pushes and pops: the second one is like
    // the third.
    test::dump_state(session.gl);
    const auto before = test::dump_state(session.gl);
    session.ask_again();
    session.call(command, random);
    const GLenum error = session.gl.GetError();
    if (error == GL_NO_ERROR || !session.answers()) return;
    const auto differences = test::changed(before, test::dump_state(session.gl));
    session.ask_again();
    if (differences.empty()) return;
    for (const std::string& line : differences)
        std::fprintf(stderr, "fuzz: changed by a call with error 0x%x: %s\n", error, line.c_str());
    std::abort();
}

void check_error(Session& session) {
    const Session::Announced call(session, "glGetError", "glGetError()");
    const GLenum error = session.gl.GetError();
    if (error == GL_NO_ERROR || (error >= GL_INVALID_ENUM && error <= GL_INVALID_FRAMEBUFFER_OPERATION))
        return;
    std::fprintf(stderr, "fuzz: 0x%x is no error of GL\n", error);
    std::abort();
}

void check(Session& session, Random& random) {
    if (session.model()) session.model()->memory.check();
    if (random.one_in(4)) return check_refusal(session, random);
    check_error(session);
}

struct Operation {
    unsigned weight;
    void (*run)(Session&, Random&);
};

constexpr Operation kOperations[] = {{560, any_call},  {100, primitive},  {70, balance},      {40, settle},
                                     {30, texture},    {25, framebuffer}, {25, buffer},       {40, arrays},
                                     {25, list},       {40, pixels},      {10, touch_mapped}, {8, check},
                                     {8, unknown_call}};
constexpr unsigned kWindowWeight = 24, kContextWeight = 6;

}  // namespace

void run_operation(Session& session, WindowSystem& windows, Random& random) {
    unsigned sum = kWindowWeight + kContextWeight;
    for (const Operation& operation : kOperations) sum += operation.weight;
    unsigned left = random.below(sum);
    if (left < kWindowWeight) return windows.operate(session, random);
    left -= kWindowWeight;
    if (left < kContextWeight || !session.model()) return windows.change_context(session, random);
    left -= kContextWeight;
    for (const Operation& operation : kOperations) {
        if (left < operation.weight) return operation.run(session, random);
        left -= operation.weight;
    }
}

}  // namespace terrazzo::fuzz
