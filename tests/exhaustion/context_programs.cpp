// OSMesa's calls: contexts, other sizes and buffers, sharing, threads.
#include <thread>

#include "program.h"

namespace terrazzo::test {
namespace {

void make_current(Run& r, OSMesaContext context, GuardedBuffer& buffer, int width, int height) {
    r.refused = !r.osmesa.MakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, width, height);
}

void create_other(Run& r, OSMesaContext share) {
    r.other = r.osmesa.CreateContextExt(OSMESA_BGRA, 16, 0, 0, share);
    r.refused = r.other == nullptr;
}

void read_depth(Run& r, std::size_t result) {
    GLint width = 0, height = 0, bytes = 0;
    void* depth = nullptr;
    r.refused = !r.osmesa.GetDepthBuffer(r.osmesa.GetCurrentContext(), &width, &height, &bytes, &depth);
    if (r.refused) return;
    const auto* const values = static_cast<const std::uint8_t*>(depth);
    r.results[result].assign(values, values + std::ptrdiff_t{width} * height * bytes);
}

Program sizes() {
    return {"OtherSizes",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
             TERRAZZO_CALL(gl.Enable(GL_DEPTH_TEST)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(read_depth(r, 0)), TERRAZZO_CALL(gl.Rectf(-0.4f, -0.4f, 0.4f, 0.4f)),
             TERRAZZO_CALL(gl.Flush()), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(make_current(r, r.context, r.large, 2 * kWidth, 2 * kHeight)),
             TERRAZZO_CALL(gl.ClearColor(0.3f, 0, 0, 1)),
             TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);), TERRAZZO_CALL(read_depth(r, 1)),
             TERRAZZO_CALL(gl.Finish()), TERRAZZO_CALL(gl.Rectf(0.2f, 0.2f, 1, 1)),
             TERRAZZO_CALL(make_current(r, r.context, r.picture, kWidth, kHeight)),
             TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);), TERRAZZO_CALL(gl.Finish())}};
}

// So large that its planes are mapped, not allocated.
void make_huge(Run& r) {
    constexpr int kSide = 768;
    if (!r.huge) r.huge.emplace(std::size_t{4} * kSide * kSide);
    make_current(r, r.context, *r.huge, kSide, kSide);
}

Program huge() {
    return {"HugePicture",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl)), TERRAZZO_CALL(make_huge(r)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl)), TERRAZZO_CALL(gl.Finish())}};
}

void make_list(const kit::Gl& gl) {
    gl.NewList(3, GL_COMPILE);
    GLint compiling = 0;
    gl.GetIntegerv(GL_LIST_INDEX, &compiling);
    if (!compiling) return;
    draw_textured(gl);
    gl.EndList();
}

Program sharing() {
    return {"SharedContexts",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 2)),
             TERRAZZO_CALL(gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)),
             TERRAZZO_CALL(gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE,
                                         "abcdEFGHijklMNOP")),
             TERRAZZO_BLOCK("list", make_list(gl)),
             TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(create_other(r, r.context)),
             TERRAZZO_CALL(make_current(r, r.other, r.large, kWidth, 2 * kHeight)),
             TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 2)),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)),
             TERRAZZO_BLOCK("call", gl.CallList(3);),
             TERRAZZO_CALL(gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, "xyz.")),
             TERRAZZO_CALL(gl.Scalef(0.5f, 0.5f, 1)),
             TERRAZZO_BLOCK("call", gl.CallList(3)),
             TERRAZZO_CALL(make_current(r, r.context, r.picture, kWidth, kHeight)),
             TERRAZZO_CALL(gl.BindTexture(GL_TEXTURE_2D, 2)),
             TERRAZZO_CALL(gl.Enable(GL_TEXTURE_2D)),
             TERRAZZO_CALL(gl.Scalef(0.3f, 0.5f, 1)),
             TERRAZZO_BLOCK("call", gl.CallList(3)),
             TERRAZZO_CALL(gl.Finish())}};
}

// A thread of its own draws with a context of its own.
void draw_in_thread(Run& r) {
    std::thread([&] {
        make_current(r, r.other, r.large, kWidth, kHeight);
        if (r.refused) return;
        r.gl.ClearColor(0, 0.4f, 0, 1);
        r.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_triangle(r.gl);
        r.gl.Finish();
        r.refused = r.gl.GetError() != GL_NO_ERROR;
        // As long as it is refused the context stays where it is until the thread ends.
        r.osmesa.MakeCurrent(nullptr, nullptr, 0, 0, 0);
    }).join();
}

Program threads() {
    return {"Threads",
            {TERRAZZO_CALL(gl.Clear(GL_COLOR_BUFFER_BIT)), TERRAZZO_BLOCK("triangle", draw_triangle(gl);),
             TERRAZZO_CALL(create_other(r, nullptr)), TERRAZZO_BLOCK("thread", draw_in_thread(r);),
             TERRAZZO_CALL(gl.Rectf(0, 0, 0.4f, 0.4f)), TERRAZZO_BLOCK("thread", draw_in_thread(r);),
             TERRAZZO_CALL(gl.Finish())}};
}

}  // namespace

std::vector<Program> context_programs() {
    return {sizes(), huge(), sharing(), threads()};
}

}  // namespace terrazzo::test
