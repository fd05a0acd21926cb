// Stage: models from files, all of it: the document, then the chosen scene's nodes, then for each of their
// primitives a geometry and a place. What cannot be drawn is left out with a note; a file of which nothing is
// left is refused.
#include "load_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <stdexcept>
#include <tuple>

#include "geometry.h"
#include "scene_tree.h"

namespace terrazzo::gltf {
namespace {

// A draw call costs about as much as so many vertices.
constexpr std::size_t kVerticesOfAPart = 16;
// What a vertex may have: attributes, morph targets, joints.
constexpr std::size_t kAttributes = 16;

class Loader {
  public:
    Loader(const std::string& path, const LoadOptions& options, Notes& notes)
        : m_notes(notes),
          m_bytes(options.limits.bytes, "--max-bytes"),
          m_pixels(options.limits.pixels, "--max-pixels"),
          m_vertices(options.limits.vertices, "--max-vertices"),
          m_drawn(options.limits.vertices, "--max-vertices"),
          m_elements(options.limits.vertices * kAttributes, "--max-vertices"),
          m_document(read_document(path, m_bytes, notes)),
          m_accessors(m_document, options.limits.vertices, m_elements),
          m_textures(m_document, m_pixels, m_bytes, notes),
          m_materials(m_document, m_textures, notes),
          m_tree(m_document.file, options.scene, notes) {}

    Model load() {
        for (const int node : m_tree.nodes()) add_node(node);
        m_model.materials = m_materials.take();
        m_model.textures = m_textures.take();
        m_model.cameras = m_tree.cameras(m_notes);
        return std::move(m_model);
    }

  private:
    void add_node(int index) {
        const tinygltf::Node& node = m_document.file.nodes[static_cast<std::size_t>(index)];
        if (node.mesh < 0) return;
        try {
            const tinygltf::Mesh& mesh = at(m_document.file.meshes, node.mesh, "mesh");
            Bending bending{node.weights.empty() ? mesh.weights : node.weights, {}};
            if (node.skin >= 0) {
                m_drawn.spend(at(m_document.file.skins, node.skin, "skin").joints.size());
                bending.joints = m_tree.joints(node.skin, m_accessors);
            }
            if (!is_finite(m_tree.place(index))) refuse("its node is not at a finite place");
            for (std::size_t i = 0; i < mesh.primitives.size(); ++i) add_part(index, i, mesh, bending);
        } catch (const std::runtime_error& failure) {
            m_notes.add("the mesh of nodes[" + std::to_string(index) + "] is not drawn: " + failure.what());
        }
    }

    void add_part(int node, std::size_t primitive, const tinygltf::Mesh& mesh, const Bending& bending) {
        m_drawn.spend(kVerticesOfAPart);  // also for what turns out to be nothing, or is nothing once more
        const int material = m_materials.find(mesh.primitives[primitive].material);
        if (m_materials.surface(material).invisible) return;
        try {
            Part part;
            part.material = material;
            part.geometry = geometry_of(node, primitive, mesh, bending, material);
            if (part.geometry < 0) return;
            m_drawn.spend(geometry(part).indices.size());
            // A skin's joints alone say where its mesh is.
            place(bending.joints.empty() ? m_tree.place(node) : kIdentity, part);
            m_model.parts.push_back(part);
        } catch (const std::runtime_error& failure) {
            m_notes.add("primitive " + std::to_string(primitive) + " of mesh " + mesh.name +
                        " is not drawn: " + failure.what());
        }
    }

    const Geometry& geometry(const Part& part) const {
        return m_model.geometries[static_cast<std::size_t>(part.geometry)];
    }

    // Nodes that do not bend their mesh share what it is made of. -1: it could not be drawn before.
    int geometry_of(int index, std::size_t primitive, const tinygltf::Mesh& mesh, const Bending& bending,
                    int material) {
        const tinygltf::Node& node = m_document.file.nodes[static_cast<std::size_t>(index)];
        const bool bent = node.skin >= 0 || !node.weights.empty();
        const std::tuple key(node.mesh, primitive, bent ? index : -1);
        if (const auto known = m_known.find(key); known != m_known.end()) return known->second;
        m_known[key] = -1;
        m_model.geometries.push_back(make_geometry(mesh.primitives[primitive], m_materials.surface(material),
                                                   bending, m_accessors, m_vertices, m_notes));
        return m_known[key] = static_cast<int>(m_model.geometries.size()) - 1;
    }

    static void place(const Matrix& matrix, Part& part) {
        for (std::size_t i = 0; i < 16; ++i) part.matrix[i] = static_cast<float>(matrix[i]);
        part.mirrored = determinant(matrix) < 0;
    }

    Notes& m_notes;
    Budget m_bytes, m_pixels, m_vertices, m_drawn, m_elements;
    Document m_document;
    Accessors m_accessors;
    Textures m_textures;
    Materials m_materials;
    SceneTree m_tree;
    std::map<std::tuple<int, std::size_t, int>, int> m_known;
    Model m_model;
};

struct Box {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};

    void include(const double (&point)[3]) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    }
};

Box box_of(const Geometry& geometry, const Part& part) {
    Box box;
    for (const std::uint32_t index : geometry.indices) {
        const float* p = &geometry.positions[std::size_t{index} * 3];
        const float* m = part.matrix;
        double point[3];
        for (std::size_t row = 0; row < 3; ++row)
            point[row] =
                double{m[row]} * p[0] + double{m[4 + row]} * p[1] + double{m[8 + row]} * p[2] + m[12 + row];
        box.include(point);
    }
    return box;
}

void find_bounds(Model& model) {
    Box all;
    for (Part& part : model.parts) {
        const Box box = box_of(model.geometries[static_cast<std::size_t>(part.geometry)], part);
        for (std::size_t axis = 0; axis < 3; ++axis)
            part.centre[axis] = static_cast<float>((box.low[axis] + box.high[axis]) / 2);
        all.include(box.low);
        all.include(box.high);
    }
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        model.centre[axis] = static_cast<float>((all.low[axis] + all.high[axis]) / 2);
        squared += (all.high[axis] - all.low[axis]) * (all.high[axis] - all.low[axis]) / 4;
    }
    model.radius = static_cast<float>(std::sqrt(squared));
    if (!std::isfinite(model.radius)) refuse("it is too large");
    // Points in one place are seen from somewhere, too.
    if (!(model.radius > 1e-30F)) model.radius = 1;
}

LoadedModel load(const std::string& path, const LoadOptions& options, Notes& notes) {
    LoadedModel loaded{Loader(path, options, notes).load(), {}};
    if (loaded.model.parts.empty()) {
        std::string reason = "there is nothing to draw";
        for (const std::string& note : notes.sentences()) reason += "; " + note;
        refuse(reason);
    }
    find_bounds(loaded.model);
    loaded.notes = notes.sentences();
    return loaded;
}

}  // namespace

LoadedModel load_model(const std::string& path, const LoadOptions& options) {
    Notes notes;
    try {
        return load(path, options, notes);
    } catch (const std::bad_alloc&) {
        throw std::runtime_error(path + ": there is not enough memory for it");
    } catch (const std::length_error&) {
        throw std::runtime_error(path + ": there is not enough memory for it");
    } catch (const std::exception& failure) {
        throw std::runtime_error(path + ": " + failure.what());
    }
}

}  // namespace terrazzo::gltf
