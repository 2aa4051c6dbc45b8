#include "stability/shapes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace cleave {
namespace {

constexpr double kPi = std::numbers::pi;

// A mesh that grows by vertices that may be there already.
class SharingMesh {
  public:
    uint32_t vertex(const dvec3& v) {
        const auto [at, isNew] = known_.try_emplace({v.x, v.y, v.z}, static_cast<uint32_t>(mesh.vertices.size()));
        if (isNew) mesh.vertices.push_back(v);
        return at->second;
    }
    void face(const dvec3& a, const dvec3& b, const dvec3& c) {
        const uint32_t i = vertex(a), j = vertex(b);
        mesh.faces.emplace_back(i, j, vertex(c));
    }
    Mesh mesh;

  private:
    std::map<std::array<double, 3>, uint32_t> known_;
};

// The corner (x, y) of a side of the cube, seen from outside: sides 0 to 5 are +x, -x, +y, -y, +z, -z.
dvec3 onSide(uint32_t side, double x, double y) {
    const int axis = static_cast<int>(side / 2);
    dvec3 p;
    p[axis] = side % 2 == 0 ? 1.0 : -1.0;
    p[(axis + 1) % 3] = side % 2 == 0 ? x : y;
    p[(axis + 2) % 3] = side % 2 == 0 ? y : x;
    return p;
}

dvec3 onKnot(double angle) {
    const double r = 1.0 + 0.4 * std::cos(3.0 * angle);
    return {r * std::cos(2.0 * angle), r * std::sin(2.0 * angle), 0.4 * std::sin(3.0 * angle)};
}

}  // namespace

std::vector<Triangle> trianglesOf(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.faces.size());
    for (const glm::uvec3& f : mesh.faces)
        triangles.push_back({vec3(mesh.vertices[f.x]), vec3(mesh.vertices[f.y]), vec3(mesh.vertices[f.z])});
    return triangles;
}

Mesh moved(Mesh mesh, const std::function<dvec3(const dvec3&)>& place) {
    for (dvec3& v : mesh.vertices) v = place(v);
    return mesh;
}

void append(std::vector<Triangle>& to, const std::vector<Triangle>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

Mesh icosphere(uint32_t level) {
    SharingMesh sphere;
    const std::function<void(const dvec3&, const dvec3&, const dvec3&, uint32_t)> refine =
        [&](const dvec3& a, const dvec3& b, const dvec3& c, uint32_t levels) {
            if (levels == 0) return sphere.face(a, b, c);
            const dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
            refine(a, ab, ca, levels - 1);
            refine(ab, b, bc, levels - 1);
            refine(ca, bc, c, levels - 1);
            refine(ab, bc, ca, levels - 1);
        };
    // An octahedron's 8 faces would do; the icosahedron's 20 are closer to equal.
    const double g = std::numbers::phi;
    const std::array<dvec3, 12> v = {{{-1, g, 0},
                                      {1, g, 0},
                                      {-1, -g, 0},
                                      {1, -g, 0},
                                      {0, -1, g},
                                      {0, 1, g},
                                      {0, -1, -g},
                                      {0, 1, -g},
                                      {g, 0, -1},
                                      {g, 0, 1},
                                      {-g, 0, -1},
                                      {-g, 0, 1}}};
    constexpr uint8_t kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (const auto& f : kFaces)
        refine(glm::normalize(v[f[0]]), glm::normalize(v[f[1]]), glm::normalize(v[f[2]]), level);
    return sphere.mesh;
}

Mesh cube(uint32_t n) {
    SharingMesh box;
    const auto at = [&](uint32_t i) { return 2.0 * i / n - 1.0; };
    for (uint32_t side = 0; side < 6; ++side)
        for (uint32_t i = 0; i < n; ++i)
            for (uint32_t j = 0; j < n; ++j) {
                const dvec3 a = onSide(side, at(i), at(j)), b = onSide(side, at(i + 1), at(j));
                const dvec3 c = onSide(side, at(i + 1), at(j + 1)), d = onSide(side, at(i), at(j + 1));
                box.face(a, b, c);
                box.face(a, c, d);
            }
    return box.mesh;
}

Mesh fanCube(uint32_t n) {
    SharingMesh box;
    const auto rim = [&](uint32_t i) {
        const uint32_t edge = i / n % 4;
        const double s = 2.0 * (i % n) / n - 1.0;
        return edge == 0   ? dvec3(s, -1, 0)
               : edge == 1 ? dvec3(1, s, 0)
               : edge == 2 ? dvec3(-s, 1, 0)
                           : dvec3(-1, -s, 0);
    };
    for (uint32_t side = 0; side < 6; ++side)
        for (uint32_t i = 0; i < 4 * n; ++i) {
            const dvec3 p = rim(i), q = rim(i + 1);
            box.face(onSide(side, 0.1 * side - 0.3, 0.2), onSide(side, p.x, p.y), onSide(side, q.x, q.y));
        }
    return box.mesh;
}

dvec3 knotCentre(uint32_t ring, uint32_t rings) { return onKnot(2.0 * kPi * (ring % rings) / rings); }

Mesh torusKnot(uint32_t rings, uint32_t sides) {
    Mesh mesh;
    for (uint32_t i = 0; i < rings; ++i) {
        // The ring lies across the curve; a fixed direction that the curve never takes orients it.
        const double angle = 2.0 * kPi * i / rings;
        const dvec3 along = glm::normalize(onKnot(angle + 1e-4) - onKnot(angle - 1e-4));
        const dvec3 p = glm::normalize(glm::cross(along, dvec3(0, 0, 1))), q = glm::cross(along, p);
        for (uint32_t j = 0; j < sides; ++j) {
            const double turn = 2.0 * kPi * j / sides;
            mesh.vertices.push_back(onKnot(angle) + 0.25 * (std::cos(turn) * p + std::sin(turn) * q));
        }
    }
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t j = 0; j < sides; ++j) {
            const uint32_t next = (i + 1) % rings, beside = (j + 1) % sides;
            const uint32_t a = i * sides + j, b = next * sides + j, c = next * sides + beside, d = i * sides + beside;
            mesh.faces.emplace_back(a, b, c);
            mesh.faces.emplace_back(a, c, d);
        }
    return mesh;
}

Mesh sheet(uint32_t n) {
    SharingMesh mesh;
    const auto at = [&](uint32_t i, uint32_t j) { return dvec3(2.0 * i / n - 1.0, 0.0, 2.0 * j / n - 1.0); };
    for (uint32_t i = 0; i < n; ++i)
        for (uint32_t j = 0; j < n; ++j) {
            mesh.face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            mesh.face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return mesh.mesh;
}

std::vector<Triangle> looseTriangles(Random& random, uint32_t count, double size) {
    std::vector<Triangle> triangles;
    for (uint32_t i = 0; i < count; ++i) {
        const dvec3 centre = random.inBox(dvec3(0.0), dvec3(1.0));
        const dvec3 a = centre + size * random.direction(), b = centre + size * random.direction();
        triangles.push_back({vec3(a), vec3(b), vec3(centre + size * random.direction())});
    }
    return triangles;
}

}  // namespace cleave
