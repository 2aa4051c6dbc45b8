// A user's own names, which are names in the sources of cleave.glsl as well.
struct Tree {
    CleaveTree still;
    CleaveTree moving;
};

struct Ray {
    vec3 from;
    vec3 to;
};

struct Hit {
    vec3 point;
    bool shadowed;
};

const int kNone = -1;

bool isLeaf(int branch) { return branch == kNone; }

vec3 infinity(Ray ray) { return ray.from + 1.0e6 * (ray.to - ray.from); }

Hit trace(Tree tree, Ray ray) {
    vec3 direction = ray.to - ray.from;
    CleaveHit hit = cleaveTrace(tree.still, ray.from, 0.0, direction, 1.0);
    Hit own;
    own.point = hit.prim == kCleaveNone ? infinity(ray) : ray.from + hit.t * direction;
    own.shadowed = isLeaf(int(hit.prim)) || cleaveOccluded(tree.moving, own.point, 1.0e-3, vec3(0.0, 1.0, 0.0), 1.0e30);
    return own;
}
