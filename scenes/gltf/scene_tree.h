// Stage: models from files, nodes. Input: tinygltf's nodes, scenes, skins, cameras. Output: where each node
// is, and which of them a scene draws. Invariant: nodes form trees, or the file is refused: so each is
// visited once, and neither depth nor number can make that long.
#pragma once

#include <vector>

#include "accessors.h"
#include "matrix.h"
#include "model.h"

namespace terrazzo::gltf {

class SceneTree {
  public:
    // Throws std::runtime_error for nodes that are no trees, and for a scene that is not there.
    SceneTree(const tinygltf::Model& file, int scene, Notes& notes);

    // In the order in which the file names them, parents before children.
    const std::vector<int>& nodes() const { return m_nodes; }
    // From a node's own coordinates to the scene's.
    const Matrix& place(int node) const { return m_places[static_cast<std::size_t>(node)]; }
    std::vector<Camera> cameras(Notes& notes) const;
    // One matrix a joint, from the mesh's coordinates to the scene's. Throws std::runtime_error.
    std::vector<Matrix> joints(int skin, const Accessors& accessors) const;

  private:
    void find_parents(Notes& notes);
    void find_places();
    std::vector<int> roots(int scene, Notes& notes) const;

    const tinygltf::Model& m_file;
    std::vector<int> m_parents;
    std::vector<Matrix> m_places;
    std::vector<int> m_nodes;
};

}  // namespace terrazzo::gltf
