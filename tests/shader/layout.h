// One of each struct that both languages read; layout.comp fills it, layout_test.cpp looks for what it wrote.
#ifndef CLEAVE_TESTS_LAYOUT_H
#define CLEAVE_TESTS_LAYOUT_H
#include "shared/build.h"
#include "shared/compact.h"
#include "shared/peer_trace.h"
#include "shared/picture_args.h"
#include "shared/placed_mesh.h"
#include "shared/pose.h"
#include "shared/query.h"
#include "shared/trace.h"

CLEAVE_BEGIN

struct LayoutRecord {
    Box box;
    KdNode node;
    Split split;
    Ray ray;
    Hit hit;
    Triangle triangle;
    TreeTriangle treeTriangle;
    Material material;
    TextureMap textureMap;
    LightSource light;
    AliasSlot aliasSlot;
    SpecularAlbedo albedo;
    PrimRef ref;
    BuildNode buildNode;
    Chunk chunk;
    StepCount steps;
    TraceCounters counters;
    BuildState state;
    NearestFaces faces;
    SceneState scene;
    TreeData tree;
    GeometryData geometry;
    Trail trail;
    ImageCamera camera;
    PictureState picture;
    BuildArgs buildArgs;
    PictureArgs pictureArgs;
    BuildPush buildPush;
    TracePush tracePush;
    CompactPush compactPush;
    PicturePush picturePush;
    PeerTracePush peerPush;
    QueryPush queryPush;
    PlacedMesh placed;
    PlaceNode placeNode;
    PlacedScene placedScene;
    PosePart posePart;
    PoseMorph poseMorph;
    PoseInfluence influence;
    AffineMap affineMap;
    PosePush posePush;
};

// The fields of the structs that were added last, in their order: what both sides walk, counting up from kFirstListed.
// A scalar has a number, an address the same in its low word.
// clang-format off
#define CLEAVE_LAYOUT_FIELDS(UINT, INT, FLOAT, DOUBLE, ADDRESS)                                                  \
    UINT(faces.below) UINT(faces.above) UINT(faces.left) UINT(faces.rightBelow) UINT(faces.right)                \
    UINT(faces.planar)                                                                                           \
    UINT(scene.largest) UINT(scene.included) UINT(scene.nonFinite) UINT(scene.noArea) UINT(scene.boundsBits[0])  \
    UINT(scene.boundsBits[5])                                                                                    \
    UINT(tree.magic) UINT(tree.format) UINT(tree.status) UINT(tree.levels) UINT(tree.triangleCount)              \
    UINT(tree.nodeCount) UINT(tree.leafRefCount) UINT(tree.nonFinite) UINT(tree.noArea) INT(tree.exponent)       \
    FLOAT(tree.bounds.lo.x) FLOAT(tree.bounds.hi.z) UINT(tree.wantedRefs) UINT(tree.wantedLevelNodes)            \
    UINT(tree.wantedNodes) UINT(tree.wantedLeafRefs) UINT(tree.bytes.x) UINT(tree.bytes.y)                       \
    UINT(tree.wantedBytes.x) UINT(tree.wantedBytes.y) UINT(tree.reserved.x) UINT(tree.reserved.y)                \
    ADDRESS(tree.triangles, TreeTriangleArray) ADDRESS(tree.nodes, KdNodeArray)                                  \
    ADDRESS(tree.leafRefs, UintArray)                                                                            \
    FLOAT(treeTriangle.a.x) FLOAT(treeTriangle.b.y) FLOAT(treeTriangle.c.z) UINT(treeTriangle.number)            \
    ADDRESS(geometry.vertices, FloatArray) ADDRESS(geometry.indices, UintArray)                                  \
    ADDRESS(geometry.transform, FloatArray) UINT(geometry.stride) UINT(geometry.vertexCount)                     \
    UINT(geometry.firstTriangle) UINT(geometry.indexBits) UINT(geometry.hasTransform) UINT(geometry.reserved)    \
    UINT(trail.upper) UINT(trail.lower)                                                                          \
    DOUBLE(camera.eye.x) DOUBLE(camera.forward.y) DOUBLE(camera.right.z) DOUBLE(camera.up.x)                     \
    DOUBLE(camera.pixel) UINT(camera.width) UINT(camera.height) UINT(camera.orthographic) FLOAT(camera.tMax)     \
    UINT(picture.lowBits) UINT(picture.highBits) UINT(picture.prefix) UINT(picture.rank)                         \
    UINT(picture.histogram[0]) UINT(picture.histogram[255]) UINT(picture.primary.invalidRays)                    \
    UINT(picture.shadow.unfinishedRays)                                                                          \
    ADDRESS(buildArgs.state, BuildStateRef) ADDRESS(buildArgs.header, Tree) ADDRESS(buildArgs.list, UintArray)   \
    UINT(buildArgs.triangleCount) UINT(buildArgs.numberCount) UINT(buildArgs.geometryCount)                      \
    UINT(buildArgs.refCapacity) UINT(buildArgs.levelNodeCapacity) UINT(buildArgs.nodeCapacity)                   \
    UINT(buildArgs.leafRefCapacity) UINT(buildArgs.binCount) UINT(buildArgs.exactUpTo) UINT(buildArgs.maxDepth)  \
    UINT(buildArgs.clip) UINT(buildArgs.subsample) UINT(buildArgs.snap) UINT(buildArgs.row)                      \
    FLOAT(buildArgs.invBinCount) FLOAT(buildArgs.costs.traverse) FLOAT(buildArgs.costs.intersect)                \
    FLOAT(buildArgs.costs.leaf) FLOAT(buildArgs.costs.emptyBonus)                                                \
    ADDRESS(pictureArgs.state, PictureStateRef) FLOAT(pictureArgs.bounds.hi.z) INT(pictureArgs.exponent)                                  \
    ADDRESS(pictureArgs.triangles, TriangleArray) ADDRESS(pictureArgs.surfaceOf, NumberArray)                    \
    ADDRESS(pictureArgs.materials, MaterialArray) ADDRESS(pictureArgs.normals, Vec3Array)                        \
    ADDRESS(pictureArgs.texels, TexelArray) ADDRESS(pictureArgs.lights, LightArray)                              \
    ADDRESS(pictureArgs.emitters, AliasArray) ADDRESS(pictureArgs.albedo, AlbedoTable)                           \
    DOUBLE(pictureArgs.camera.pixel) UINT(pictureArgs.view)                                                      \
    UINT(pictureArgs.count) UINT(pictureArgs.samples) FLOAT(pictureArgs.exposure) FLOAT(pictureArgs.ambientReach)                                \
    FLOAT(pictureArgs.settings.sky.horizon.x) FLOAT(pictureArgs.settings.sky.zenith.z)                           \
    UINT(pictureArgs.settings.lightCount) UINT(pictureArgs.settings.emitters.slots)                              \
    FLOAT(pictureArgs.settings.emitters.scale) UINT(pictureArgs.settings.bounces) UINT(pictureArgs.settings.seed)     \
    FLOAT(material.baseColour.x) FLOAT(material.emission.z) FLOAT(material.metallic) FLOAT(material.roughness)   \
    FLOAT(material.alphaCutoff) UINT(material.flags) UINT(material.emissionMap) FLOAT(material.brightness)      \
    UINT(textureMap.first) UINT(textureMap.flags) FLOAT(textureMap.turn.w) FLOAT(textureMap.offset.y)            \
    FLOAT(light.position.x) UINT(light.kind) FLOAT(light.direction.y) FLOAT(light.capHeight)                     \
    FLOAT(light.intensity.z) FLOAT(light.range) FLOAT(light.cosInner) FLOAT(light.cosOuter)                      \
    UINT(aliasSlot.first) UINT(aliasSlot.second) FLOAT(aliasSlot.chance)                                         \
    FLOAT(albedo.edge) FLOAT(albedo.loss)                                                                        \
    ADDRESS(buildPush.args, BuildArgsRef) UINT(buildPush.depth) UINT(buildPush.scans)                            \
    ADDRESS(tracePush.tree, Tree) ADDRESS(tracePush.rays, RayArray) ADDRESS(tracePush.hits, HitArray)            \
    ADDRESS(tracePush.steps, StepCountArray) ADDRESS(tracePush.counters, TraceCountersRef)                       \
    ADDRESS(tracePush.trails, TrailArray) UINT(tracePush.rayCount) UINT(tracePush.stepLimit)                     \
    UINT(tracePush.flags) UINT(tracePush.hitsPerRay) INT(tracePush.hitExponent)                                  \
    ADDRESS(queryPush.tree, Tree) ADDRESS(queryPush.items, FloatArray) ADDRESS(queryPush.nearest, HitArray)      \
    ADDRESS(queryPush.answers, UintArray) ADDRESS(queryPush.first, UintArray)                                    \
    ADDRESS(queryPush.triangles, UintArray) UINT(queryPush.count) FLOAT(queryPush.within)                        \
    ADDRESS(compactPush.from, Tree) ADDRESS(compactPush.to, Tree) UINT(compactPush.invocations)                  \
    ADDRESS(picturePush.args, PictureArgsRef) UINT(picturePush.round) UINT(picturePush.path) UINT(picturePush.first) UINT(picturePush.end)                                            \
    ADDRESS(peerPush.scene, uvec2) ADDRESS(peerPush.rays, RayArray) ADDRESS(peerPush.hits, HitArray)             \
    UINT(peerPush.rayCount) UINT(peerPush.reserved)                                                              \
    DOUBLE(placed.x.y) DOUBLE(placed.y.z) DOUBLE(placed.z.x) DOUBLE(placed.origin.z) DOUBLE(placed.inverseX.x)   \
    DOUBLE(placed.inverseY.y) DOUBLE(placed.inverseZ.z) FLOAT(placed.error) FLOAT(placed.norm)                   \
    ADDRESS(placed.tree, Tree) UINT(placed.first) INT(placed.shift) UINT(placed.isWorld) UINT(placed.reserved)   \
    FLOAT(placeNode.box.hi.x) UINT(placeNode.axis) UINT(placeNode.reserved)                                      \
    ADDRESS(placedScene.nodes, PlaceNodeArray) ADDRESS(placedScene.meshes, PlacedMeshArray)                      \
    UINT(placedScene.count) INT(placedScene.exponent)                                                            \
    UINT(posePart.firstPosed) UINT(posePart.firstVertex) UINT(posePart.firstMorph) UINT(posePart.morphCount)     \
    UINT(posePart.firstWeight) UINT(posePart.firstInfluence) UINT(posePart.influenceCount)                       \
    UINT(posePart.firstJoint) UINT(posePart.map) UINT(posePart.reserved)                                         \
    UINT(poseMorph.weight) UINT(poseMorph.firstDelta)                                                            \
    DOUBLE(influence.weight) UINT(influence.joint) UINT(influence.reserved)                                      \
    DOUBLE(affineMap.x.x) DOUBLE(affineMap.y.y) DOUBLE(affineMap.z.z) DOUBLE(affineMap.origin.z)                 \
    ADDRESS(posePush.parts, PosePartArray) ADDRESS(posePush.positions, PosePointArray)                           \
    ADDRESS(posePush.morphs, PoseMorphArray) ADDRESS(posePush.deltas, PosePointArray)                            \
    ADDRESS(posePush.influences, PoseInfluenceArray) ADDRESS(posePush.maps, AffineMapArray)                      \
    ADDRESS(posePush.weights, PoseWeightArray) ADDRESS(posePush.posed, PoseWordArray)                            \
    ADDRESS(posePush.corners, PoseWordArray) ADDRESS(posePush.numbers, PoseWordArray)                            \
    ADDRESS(posePush.triangles, PoseWordArray)                                                                   \
    UINT(posePush.partCount) UINT(posePush.vertexCount) UINT(posePush.triangleCount) UINT(posePush.reserved)

// clang-format on

// The arrays of builds and pictures, by their lists.
#define CLEAVE_LAYOUT_ARRAYS(BUILD, PICTURE) \
    CLEAVE_SCRATCH_ARRAYS(BUILD) CLEAVE_TREE_ARRAYS(BUILD) CLEAVE_PICTURE_ARRAYS(PICTURE)

CLEAVE_CONST uint kFirstListed = 200u;

CLEAVE_END
#endif
