// glTF 2.0 §3.5.2: every node has at most one parent, and none is below itself.
#include "scene_tree.h"

#include <algorithm>
#include <numbers>

namespace terrazzo::gltf {
namespace {

Matrix rotation_and_scale(const tinygltf::Node& node) {
    double x = 0, y = 0, z = 0, w = 1, s[3] = {1, 1, 1};
    if (node.rotation.size() == 4)
        x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
    const double length = std::sqrt(x * x + y * y + z * z + w * w);
    if (length > 0 && std::isfinite(length)) {
        x /= length, y /= length, z /= length, w /= length;
    } else {
        x = y = z = 0, w = 1;
    }
    if (node.scale.size() == 3) std::copy(node.scale.begin(), node.scale.end(), s);
    return {(1 - 2 * (y * y + z * z)) * s[0],
            2 * (x * y + w * z) * s[0],
            2 * (x * z - w * y) * s[0],
            0,
            2 * (x * y - w * z) * s[1],
            (1 - 2 * (x * x + z * z)) * s[1],
            2 * (y * z + w * x) * s[1],
            0,
            2 * (x * z + w * y) * s[2],
            2 * (y * z - w * x) * s[2],
            (1 - 2 * (x * x + y * y)) * s[2],
            0,
            0,
            0,
            0,
            1};
}

Matrix matrix_of(const tinygltf::Node& node) {
    Matrix matrix = kIdentity;
    if (node.matrix.size() == 16) {
        std::copy(node.matrix.begin(), node.matrix.end(), matrix.begin());
        return matrix;
    }
    matrix = rotation_and_scale(node);
    if (node.translation.size() == 3)
        std::copy(node.translation.begin(), node.translation.end(), matrix.begin() + 12);
    return matrix;
}

// The camera's place without its scale (glTF 2.0 §3.10), from the scene to the eye.
bool set_view(const Matrix& place, float (&view)[16]) {
    double axes[3][3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double* column = &place[axis * 4];
        const double length =
            std::sqrt(column[0] * column[0] + column[1] * column[1] + column[2] * column[2]);
        if (!(length > 0) || !std::isfinite(length)) return false;
        for (std::size_t i = 0; i < 3; ++i) axes[axis][i] = column[i] / length;
    }
    for (std::size_t row = 0; row < 3; ++row) {
        double shift = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            view[i * 4 + row] = static_cast<float>(axes[row][i]);
            shift -= axes[row][i] * place[12 + i];
        }
        view[12 + row] = static_cast<float>(shift);
        view[row * 4 + 3] = 0;
    }
    view[15] = 1;
    return std::isfinite(view[12]) && std::isfinite(view[13]) && std::isfinite(view[14]);
}

bool set_lens(const tinygltf::Camera& source, Camera& camera) {
    camera.perspective = source.type == "perspective";
    if (camera.perspective) {
        const tinygltf::PerspectiveCamera& lens = source.perspective;
        camera.field_of_view = static_cast<float>(lens.yfov);
        camera.near_plane = static_cast<float>(lens.znear);
        camera.far_plane = static_cast<float>(lens.zfar);
        const bool endless = camera.far_plane == 0;
        return camera.field_of_view > 1e-3F && camera.field_of_view < std::numbers::pi_v<float> - 1e-3F &&
               camera.near_plane > 0 && (endless || camera.far_plane > camera.near_plane) &&
               std::isfinite(camera.far_plane);
    }
    const tinygltf::OrthographicCamera& lens = source.orthographic;
    camera.half_size[0] = static_cast<float>(lens.xmag);
    camera.half_size[1] = static_cast<float>(lens.ymag);
    camera.near_plane = static_cast<float>(lens.znear);
    camera.far_plane = static_cast<float>(lens.zfar);
    return camera.half_size[0] != 0 && camera.half_size[1] != 0 && std::isfinite(camera.half_size[0]) &&
           std::isfinite(camera.half_size[1]) && camera.near_plane >= 0 &&
           camera.far_plane > camera.near_plane && std::isfinite(camera.far_plane);
}

}  // namespace

SceneTree::SceneTree(const tinygltf::Model& file, int scene, Notes& notes) : m_file(file) {
    find_parents(notes);
    find_places();
    std::vector<int> waiting = roots(scene, notes);
    std::reverse(waiting.begin(), waiting.end());
    while (!waiting.empty()) {
        const int index = waiting.back();
        waiting.pop_back();
        m_nodes.push_back(index);
        const std::vector<int>& children = file.nodes[static_cast<std::size_t>(index)].children;
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            if (*child >= 0 && static_cast<std::size_t>(*child) < file.nodes.size())
                waiting.push_back(*child);
    }
}

void SceneTree::find_parents(Notes& notes) {
    m_parents.assign(m_file.nodes.size(), -1);
    for (std::size_t node = 0; node < m_file.nodes.size(); ++node)
        for (const int child : m_file.nodes[node].children) {
            if (child < 0 || static_cast<std::size_t>(child) >= m_parents.size()) {
                notes.add("nodes[" + std::to_string(node) + "] has a child that is not there");
                continue;
            }
            int& parent = m_parents[static_cast<std::size_t>(child)];
            if (parent >= 0)
                refuse("nodes[" + std::to_string(child) + "] is a child twice, of nodes[" +
                       std::to_string(parent) + "] and nodes[" + std::to_string(node) +
                       "]; the nodes of glTF form trees");
            parent = static_cast<int>(node);
        }
}

void SceneTree::find_places() {
    m_places.assign(m_file.nodes.size(), kIdentity);
    std::vector<int> waiting;
    for (std::size_t node = 0; node < m_parents.size(); ++node)
        if (m_parents[node] < 0) waiting.push_back(static_cast<int>(node));
    std::size_t reached = 0;
    for (; !waiting.empty(); ++reached) {
        const auto index = static_cast<std::size_t>(waiting.back());
        waiting.pop_back();
        const Matrix own = matrix_of(m_file.nodes[index]);
        m_places[index] =
            m_parents[index] < 0 ? own : product(m_places[static_cast<std::size_t>(m_parents[index])], own);
        for (const int child : m_file.nodes[index].children)
            if (child >= 0 && static_cast<std::size_t>(child) < m_parents.size()) waiting.push_back(child);
    }
    // A circle has no end that the others hang on.
    if (reached < m_parents.size()) refuse("some nodes are below themselves; the nodes of glTF form trees");
}

// The scene's; without scenes, every node that is nobody's child.
std::vector<int> SceneTree::roots(int scene, Notes& notes) const {
    std::vector<int> found;
    if (m_file.scenes.empty()) {
        if (scene >= 0) refuse("it has no scene " + std::to_string(scene));
        for (std::size_t node = 0; node < m_parents.size(); ++node)
            if (m_parents[node] < 0) found.push_back(static_cast<int>(node));
        return found;
    }
    if (scene < 0) scene = std::max(m_file.defaultScene, 0);
    std::vector<bool> taken(m_parents.size(), false);
    for (const int node : at(m_file.scenes, scene, "scene").nodes) {
        if (node < 0 || static_cast<std::size_t>(node) >= m_parents.size()) {
            notes.add("the scene has a node that is not there");
            continue;
        }
        const auto index = static_cast<std::size_t>(node);
        if (m_parents[index] >= 0 || taken[index])
            refuse("nodes[" + std::to_string(node) +
                   "] is a scene's root and more than that; the nodes of glTF form trees");
        taken[index] = true;
        found.push_back(node);
    }
    return found;
}

std::vector<Camera> SceneTree::cameras(Notes& notes) const {
    std::vector<Camera> cameras;
    for (const int node : m_nodes) {
        const tinygltf::Node& source = m_file.nodes[static_cast<std::size_t>(node)];
        if (source.camera < 0) continue;
        Camera camera;
        const bool is_there = static_cast<std::size_t>(source.camera) < m_file.cameras.size();
        if (!is_there || !set_view(place(node), camera.view) ||
            !set_lens(m_file.cameras[static_cast<std::size_t>(source.camera)], camera)) {
            notes.add("the camera of nodes[" + std::to_string(node) + "] sees nothing and is ignored");
            continue;
        }
        camera.name = m_file.cameras[static_cast<std::size_t>(source.camera)].name;
        if (camera.name.empty()) camera.name = source.name;
        cameras.push_back(std::move(camera));
    }
    return cameras;
}

std::vector<Matrix> SceneTree::joints(int index, const Accessors& accessors) const {
    const tinygltf::Skin& skin = at(m_file.skins, index, "skin");
    std::vector<float> inverses;
    if (skin.inverseBindMatrices >= 0) inverses = accessors.floats(skin.inverseBindMatrices, 16);
    if (!inverses.empty() && inverses.size() < skin.joints.size() * 16)
        refuse("a skin has fewer matrices than joints");
    std::vector<Matrix> matrices;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        at(m_file.nodes, skin.joints[i], "node");
        Matrix inverse = kIdentity;
        if (!inverses.empty())
            std::copy_n(inverses.begin() + static_cast<std::ptrdiff_t>(i * 16), 16, inverse.begin());
        matrices.push_back(product(place(skin.joints[i]), inverse));
        if (!is_finite(matrices.back())) refuse("a joint of a skin is not at a finite place");
    }
    return matrices;
}

}  // namespace terrazzo::gltf
