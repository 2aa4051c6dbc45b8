// A mesh that stands in many places: one tree over it, in a space of its own, and a record of each place. Whoever walks
// the tree does so in the space of the mesh; a triangle is tested in the world, where it is made anew.
#ifndef CLEAVE_SHARED_PLACED_MESH_H
#define CLEAVE_SHARED_PLACED_MESH_H
#include "geometry.h"

CLEAVE_BEGIN

// World here is the scene's own space, where vertices are rounded to float; scaled is that of a copied scene's tree, in
// which rays are traced. A vertex v of the mesh's tree is at x v.x + y v.y + z v.z + origin in the world: the scale of
// the tree is in the axes already, exactly, since it is a power of two.
struct PlacedMesh {
    dvec3 x;
    dvec3 y;
    dvec3 z;
    dvec3 origin;
    dvec3 inverseX;  // the axes of the scaled world, less the origin, in the space of the tree
    dvec3 inverseY;
    dvec3 inverseZ;
    float error;  // how far a point of a triangle may lie there from where the world has it
    float norm;   // the largest sum of absolute values in a row of the inverse
    CLEAVE_ADDRESS(Tree) tree;
    uint first;    // number of the mesh's first triangle in the scene
    int shift;     // the scaled world's vertices are 2^shift of the world's, or of the tree's
    uint isWorld;  // 1: the tree is one over triangles of the world, which have their numbers already
    uint reserved;
};
CLEAVE_SIZE(PlacedMesh, 200);

// A node of the tree of places: the box of all that stands below it, in the scaled world. Nodes are numbered as in a
// heap: the root is 1, the children of node i are 2 i and 2 i + 1, and of n places the leaves are n to 2 n - 1.
struct PlaceNode {
    Box box;
    uint axis;  // of an inner node: along it the first child is the lower one
    uint reserved;
};
CLEAVE_SIZE(PlaceNode, 32);

#ifndef __cplusplus
CLEAVE_ARRAY(PlaceNodeArray, PlaceNode);
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PlacedMeshArray { PlacedMesh at[]; };
#endif

// What rays are traced through: the places and their tree.
struct PlacedScene {
    CLEAVE_ADDRESS(PlaceNodeArray) nodes;    // the root first
    CLEAVE_ADDRESS(PlacedMeshArray) meshes;  // in the order of leaves
    uint count;                              // of places
    int exponent;                            // world = scaled 2^exponent, as a tree of the copied scene has it
};
CLEAVE_SIZE(PlacedScene, 24);

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PlacedSceneRef { PlacedScene at; };
#endif

// A vertex of the mesh's tree in the scaled world, with every bit that the tree of a copied scene has.
CLEAVE_FN vec3 placedVertex(PlacedMesh mesh, vec3 vertex) {
    if (mesh.isWorld != 0u) return timesPowerOfTwo(vertex, mesh.shift);
    dvec3 v = dvec3(vertex);
    vec3 world = vec3(float(transformedBy(mesh.x.x, mesh.y.x, mesh.z.x, mesh.origin.x, v)),
                      float(transformedBy(mesh.x.y, mesh.y.y, mesh.z.y, mesh.origin.y, v)),
                      float(transformedBy(mesh.x.z, mesh.y.z, mesh.z.z, mesh.origin.z, v)));
    return timesPowerOfTwo(world, mesh.shift);
}

CLEAVE_END
#endif
