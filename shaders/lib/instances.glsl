// Rays through meshes that stand in many places: down the tree of places, and in each place that the ray meets down the
// tree of its mesh, in the space of the mesh. Triangles are tested in the world, against the ray as it is, so that hits
// are those of a copied scene to the last bit. Only the walk goes by the ray in the mesh's space, and must not pass over
// a cell because of what was rounded on the way there: see placedRay().
//
// A kernel includes lib/instances_before.glsl, then cleave.glsl, then this. It defines WALK, its way down a tree.

const double kDoubleSlack = 8.8817841970012523e-16LF;  // 2^-50
const float kFloatSlack = 2.384185791015625e-07;       // 2^-22
const float kLargestOrigin = 1048576.0;
const float kLargestError = 1.0e30;

float largestOf(dvec3 v) { return float(max(abs(v.x), max(abs(v.y), abs(v.z)))); }

dvec3 intoMesh(PlacedMesh mesh, dvec3 v) { return mesh.inverseX * v.x + mesh.inverseY * v.y + mesh.inverseZ * v.z; }

// A ray in the space of a mesh. Its t is that of the ray itself, less `begin`, times `rate`, a power of two.
struct PlacedRay {
    vec3 origin;
    vec3 direction;
    float tMax;
    float error;  // how far from it, at its t, a point may be where the ray itself meets a triangle
    float begin;
    float rate;
};

// The ray between the two t (tMin is at least 0) at which it may be in the box of a place.
//
// Let the exact ray meet a triangle at X = o + t d. The place's record says that R (X - b), with R its inverse and b its
// origin, is within its error of a point p of the mesh's triangle. What is computed here is c + s e, with s = t - begin:
// - c is R (o + begin d - b), rounded in double: begin d is exact, the sums and products add at most 2^-50 |R| (|o +
//   begin d - b| + |b|), and rounding to float adds 2^-24 |c|.
// - e is R d. In double, s e is off by at most 2^-50 |R| s, as |d| < 2; s is at most end - begin. Rounded to float it
//   is off by 2^-24 of itself, component by component; since c + s e is within the tree's bounds, which are at most 1, or
//   nearly so, that is at most 2^-24 (|c| + 1 + error).
// - The walk adds up to two roundings of its own, of sums with the error: 2^-24 (|c| + 1 + error) each.
// 2^-22 (|c| + 1) covers what is float here, the factor of 1.01 what is left. An origin that float cannot hold well is
// brought closer, and the ray may be anywhere within that distance.
PlacedRay placedRay(PlacedMesh mesh, int exponent, CleaveScaledRay ray, float tMin, float tMax) {
    PlacedRay seen;
    // A little earlier, and the end a little later: the t of hits are rounded.
    seen.begin = tMin * (1.0 - 2.0 * kCleaveWiden);
    float length = tMax * (1.0 + 2.0 * kCleaveWiden) - seen.begin;
    dvec3 origin = mesh.origin * powerOfTwo(-exponent);
    dvec3 from = dvec3(ray.origin) + double(seen.begin) * dvec3(ray.direction) - origin;
    dvec3 start = intoMesh(mesh, from);
    dvec3 direction = intoMesh(mesh, dvec3(ray.direction));
    int e = binaryExponent(largestOf(direction));
    direction *= powerOfTwo(-e);
    seen.rate = float(powerOfTwo(e));
    seen.origin = vec3(clamp(start, dvec3(-kLargestOrigin), dvec3(kLargestOrigin)));
    seen.direction = vec3(flushed(float(direction.x)), flushed(float(direction.y)), flushed(float(direction.z)));
    seen.tMax = length * seen.rate * (1.0 + kCleaveWiden);
    float moved = largestOf(start) > kLargestOrigin ? largestOf(start - dvec3(seen.origin)) : 0.0;
    float inDouble = float(kDoubleSlack) * mesh.norm * (largestOf(from) + largestOf(origin) + length);
    float inFloat = kFloatSlack * (largestComponent(seen.origin) + 1.0);
    seen.error = min(1.01 * (mesh.error + inDouble + inFloat + moved), kLargestError);
    return seen;
}

// Where the walk is.
PlacedMesh place;
PlacedRay seen;

vec3 placedHere(vec3 vertex) { return placedVertex(place, vertex); }
uint numberHere(uint number) { return place.first + number; }

// The tree of a copied scene is without such triangles; that of a mesh cannot know which these are.
bool hasNoArea(vec3 a, vec3 b, vec3 c) { return liesOnALine(Triangle(a, b, c)); }

void rayHere(inout vec3 origin, inout float tMin, inout vec3 direction, inout float tMax, inout float error) {
    origin = seen.origin;
    tMin = 0.0;
    direction = seen.direction;
    tMax = seen.tMax;
    error = seen.error;
}

float tHere(float t) {
    float s = (t - seen.begin) * seen.rate;
    return s + abs(s) * kCleaveWiden;
}

// Goes on from `found`, which is in the scaled world, in a place that the ray may meet between the two t.
void searchPlace(PlacedMesh mesh, int exponent, CleaveScaledRay ray, float tMin, float tMax, bool anyHit,
                 inout CleaveHit found, inout CleaveStepCount steps) {
    place = mesh;
    seen = placedRay(mesh, exponent, ray, tMin, tMax);
    CleaveTreeParts parts = cleavePartsOf(CleaveTree(uvec2(mesh.tree)));
    CleaveBest best = cleaveBestOf(found, ray);
    CleaveTrail trail = cleaveEmptyTrail();
    WALK(parts, ray, anyHit, best, trail, steps);
    if (best.index != kCleaveNone) found = cleaveHitOf(parts, ray, best);
}

// As cleaveSearch(), for a scene of places. No ray is given up: the work is bounded by the trees of all places together.
//
// Down the tree of places, the nearer child first by the direction's sign; a bit per level says that the other child is
// still to come, so that there is no stack (Barringer and Akenine-Moeller 2013).
void searchInstances(PlacedSceneRef scene, CleaveRay ray, bool anyHit, inout CleaveHit hit,
                     inout CleaveStepCount steps) {
    uint count = scene.at.count;
    if (count == 0u || (anyHit && hit.prim != kCleaveNone)) return;
    int exponent = scene.at.exponent;
    CleaveScaledRay scaled = cleaveScaledRay(ray, exponent);
    vec3 inverse = vec3(1.0) / scaled.direction;
    CleaveHit given = cleaveScaledHit(hit, scaled.tExponent);
    CleaveHit found = given;
    uint node = 1u;
    uint waiting = 0u;
    while (true) {
        PlaceNode at = scene.at.nodes.at[node - 1u];
        if (CLEAVE_COUNT_STEPS) steps.inner++;
        CleaveBox box = CleaveBox(at.box.lo, at.box.hi);
        float tMin = scaled.tMin;
        float tMax = min(scaled.tMax, found.t + abs(found.t) * kCleaveWiden);
        bool meets = cleaveClipTo(box, scaled.origin, scaled.direction, inverse, 0.0, tMin, tMax);
        if (meets && node < count) {
            node = 2u * node + (scaled.direction[at.axis] < 0.0 ? 1u : 0u);
            waiting = waiting << 1 | 1u;
            continue;
        }
        if (meets) {
            searchPlace(scene.at.meshes.at[node - count], exponent, scaled, tMin, tMax, anyHit, found, steps);
            if (anyHit && found.prim != kCleaveNone) break;
        }
        if (waiting == 0u) break;
        uint up = lowestBit(waiting);
        node = node >> up ^ 1u;
        waiting = waiting >> up ^ 1u;
    }
    // A hit that stays is not converted back: see cleaveSearch().
    if (found.prim != given.prim) hit = cleaveWorldHit(found, scaled.tExponent);
}
