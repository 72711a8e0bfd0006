// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/fcl/MeshFile.h"

#include <filesystem>
#include <iomanip>
#include <ostream>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "ColladaFile.h"
#include "specplan/problems/InputError.h"
#include "specplan/problems/OutputFile.h"
#include "specplan/problems/TextFile.h"

namespace specplan::problems
{
namespace
{
/// Adds the meshes of a node and of those below it.
void collect(const aiScene& scene, const aiNode& node, aiMatrix4x4 transform, Mesh& mesh)
{
    transform *= node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
    {
        const aiMesh& part = *scene.mMeshes[node.mMeshes[i]];
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (unsigned j = 0; j < part.mNumVertices; ++j)
        {
            const aiVector3D vertex = transform * part.mVertices[j];
            mesh.vertices.emplace_back(vertex.x, vertex.y, vertex.z);
        }
        for (unsigned j = 0; j < part.mNumFaces; ++j)
            if (const aiFace& face = part.mFaces[j]; face.mNumIndices == 3)
                mesh.triangles.push_back(
                    {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        collect(scene, *node.mChildren[i], transform, mesh);
}
}  // namespace

Mesh readMesh(const std::string& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        throw InputError(path, 0, "expected a mesh file, found none");
    if (path.ends_with(".dae") || path.ends_with(".DAE"))
        inspectCollada(path, readText(path));
    Assimp::Importer importer;
    const aiScene* scene =
        importer.ReadFile(path, aiProcess_GenNormals | aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                    aiProcess_SortByPType | aiProcess_OptimizeGraph);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw InputError(path, 0, concat("expected a mesh (COLLADA, STL, OBJ): ", importer.GetErrorString()));
    Mesh mesh;
    collect(*scene, *scene->mRootNode, aiMatrix4x4(), mesh);
    requireSound(mesh, path);
    return mesh;
}

void writeObj(const std::string& path, const Mesh& mesh)
{
    writeFile(path,
              [&mesh](std::ostream& out)
              {
                  out << std::setprecision(9);
                  for (const Eigen::Vector3d& v : mesh.vertices)
                      out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
                  for (const auto& t : mesh.triangles)
                      out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
              });
}
}  // namespace specplan::problems
