// Making and drawing the meshes; see meshes.h.
#include "meshes.h"

#include <algorithm>
#include <array>
#include <span>

#include "kit/offscreen.h"
#include "random.h"

namespace terrazzo::coverage {
namespace {

constexpr int kSize = 512;

// Points are given in 1/256 of a pixel: as sub-pixels, a mesh is flat to the window without rounding.
struct Point {
    int64_t x, y;
};

struct Mesh {
    std::vector<Point> points;
    std::vector<std::array<uint32_t, 3>> triangles;
};

// Twice the area, positive where the triangle is counter-clockwise.
int64_t area(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

// A grid of `across` cells each way over the square from `low` to `high`, its inner points moved, its
// diagonals at random.
Mesh jittered_grid(Random& random, uint32_t across, int low, int high) {
    Mesh mesh;
    const int64_t lattice = random.one_of({256, 128, 1});
    const float step = static_cast<float>(high - low) * 256 / static_cast<float>(across);
    for (uint32_t j = 0; j <= across; ++j) {
        for (uint32_t i = 0; i <= across; ++i) {
            const auto moved = [&](uint32_t at) {
                if (at == 0) return int64_t{low} * 256;
                if (at == across) return int64_t{high} * 256;
                const float v = (static_cast<float>(at) + random.number(-0.3f, 0.3f)) * step;
                return int64_t{low} * 256 + static_cast<int64_t>(v) / lattice * lattice;
            };
            const int64_t x = moved(i);
            mesh.points.push_back({x, moved(j)});
        }
    }
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) { mesh.triangles.push_back({a, b, c}); };
    for (uint32_t j = 0; j < across; ++j) {
        for (uint32_t i = 0; i < across; ++i) {
            const uint32_t a = j * (across + 1) + i, b = a + 1, c = b + across + 1, d = c - 1;
            const auto fits = [&](uint32_t i0, uint32_t i1, uint32_t i2) {
                return area(mesh.points[i0], mesh.points[i1], mesh.points[i2]) > 0;
            };
            const bool first = fits(a, b, c) && fits(a, c, d), second = fits(a, b, d) && fits(b, c, d);
            if (first && (!second || random.chance(2))) {
                add(a, b, c), add(a, c, d);
            } else {
                add(a, b, d), add(b, c, d);
            }
        }
    }
    return mesh;
}

// Cuts triangles in three at a point inside, again and again: fans, slivers, triangles smaller than a pixel.
// `least` is twice the least area, in sub-pixels, that a triangle may get.
void refine(Random& random, Mesh& mesh, size_t triangles, int64_t least) {
    for (int attempts = 0; mesh.triangles.size() < triangles && attempts < 20000; ++attempts) {
        const auto count = static_cast<uint32_t>(mesh.triangles.size());
        const size_t at = random.chance(4) ? count - 1 : random.below(count);
        const auto t = mesh.triangles[at];
        const Point a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
        const float u = random.number(0, 1), v = random.number(0, 1) * (1 - u);
        const auto mixed = [&](int64_t from, int64_t one, int64_t other) {
            return from + static_cast<int64_t>(u * static_cast<float>(one - from) +
                                               v * static_cast<float>(other - from));
        };
        const Point p{mixed(a.x, b.x, c.x), mixed(a.y, b.y, c.y)};
        if (area(a, b, p) < least || area(b, c, p) < least || area(c, a, p) < least) continue;
        const auto made = static_cast<uint32_t>(mesh.points.size());
        mesh.points.push_back(p);
        mesh.triangles[at] = {t[0], t[1], made};
        mesh.triangles.push_back({t[1], t[2], made});
        mesh.triangles.push_back({t[2], t[0], made});
    }
}

void draw(const kit::Gl& gl, const Mesh& mesh, Random& random) {
    // One step of a component; a triangle of either orientation.
    gl.Color4ub(1, 1, 1, 1);
    gl.Begin(GL_TRIANGLES);
    for (const auto& t : mesh.triangles) {
        const uint32_t turn = random.below(3);
        const bool reversed = random.chance(2);
        for (uint32_t i = 0; i < 3; ++i) {
            const Point& p = mesh.points[t[(reversed ? 2 - i + turn : i + turn) % 3]];
            gl.Vertex2f(static_cast<float>(p.x) / 256, static_cast<float>(p.y) / 256);
        }
    }
    gl.End();
}

MeshResult count(std::span<const uint8_t> picture, const Mesh& mesh) {
    MeshResult result{static_cast<uint32_t>(mesh.triangles.size()), 0, 0, 14695981039346656037u};
    for (size_t i = 0; i < picture.size(); i += 4) {
        result.missed += picture[i] == 0;
        result.doubled += picture[i] > 1;
        result.picture = (result.picture ^ picture[i]) * 1099511628211u;
    }
    return result;
}

enum class View { kFlat, kTilted, kBeyond };

void set_view(const kit::Gl& gl, View view, Random& random) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    if (view == View::kTilted) {
        gl.Frustum(-0.1, 0.1, -0.1, 0.1, 0.15, 1000);
    } else {
        gl.Ortho(0, kSize, 0, kSize, -1, 1);
    }
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    if (view != View::kTilted) return;
    // A wall seen from close by at a slant: it fills the view and, on one side, reaches behind the eye.
    const GLfloat turn[3] = {random.number(10, 40), random.number(-1, 1), random.number(-1, 1)};
    gl.Rotatef(turn[0], turn[1], turn[2], 0);
    gl.Translatef(0, 0, -random.number(2, 3));
    gl.Scalef(400.0f / kSize, 400.0f / kSize, 1);
    gl.Translatef(-kSize / 2, -kSize / 2, 0);
}

}  // namespace

std::vector<MeshResult> draw_meshes(const std::string& path, uint32_t seed, uint32_t meshes) {
    const kit::Library library(path);
    const kit::OffscreenContext context(library, {.width = kSize, .height = kSize});
    const kit::Gl& gl = library.gl;
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    std::vector<MeshResult> results;
    for (uint32_t i = 0; i < meshes; ++i) {
        Random random(seed, i);
        const auto view = static_cast<View>(i % 3);
        // Only flat to the window is a mesh sure not to fold when its points are snapped: others keep their
        // triangles larger than eight pixels.
        const int beyond = view == View::kBeyond ? 37 : 0;
        const int64_t least = view == View::kFlat ? 1 : 16 * 256 * 256;
        Mesh mesh = jittered_grid(random, 1 + random.below(30), -beyond, kSize + beyond);
        refine(random, mesh, mesh.triangles.size() + random.below(1500), least);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        set_view(gl, view, random);
        draw(gl, mesh, random);
        gl.Finish();
        results.push_back(count(context.colour_buffer(), mesh));
    }
    return results;
}

}  // namespace terrazzo::coverage
