#include "instances/place_mesh.h"

#include <algorithm>
#include <cmath>

namespace cleave {
namespace {

const double kMostError = std::ldexp(1.0, -10);
const double kLargestElement = std::ldexp(1.0, 400);

bool isPlain(double element) {
    const double size = std::fabs(element);
    return size == 0.0 || (size >= 1.0 / kLargestElement && size <= kLargestElement);
}

bool isPlain(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (!isPlain(m[column][row])) return false;
    return true;
}

// How far vertices may be from the exact A v + b, for any v of the tree. A rounding to float, by 2^-24 of the result;
// what is below the smallest normal number becomes 0; and six operations in double, each by 2^-53 of at most the sum of
// all terms. As much again is for hits that are decided in double.
glm::dvec3 roundingOf(const glm::dmat3& toWorld, const glm::dvec3& origin, const Box& box) {
    glm::dvec3 rounding;
    for (int i = 0; i < 3; ++i) {
        const double largest = std::max(std::fabs(double(box.lo[i])), std::fabs(double(box.hi[i])));
        const double terms = std::fabs(toWorld[0][i]) + std::fabs(toWorld[1][i]) + std::fabs(toWorld[2][i]);
        rounding[i] =
            std::ldexp(1.001 * largest, -24) + std::ldexp(1.0, -126) + std::ldexp(terms + std::fabs(origin[i]), -49);
    }
    return rounding;
}

double sumOfRow(const glm::dmat3& m, int row) {
    return std::fabs(m[0][row]) + std::fabs(m[1][row]) + std::fabs(m[2][row]);
}

// Let a point p of a triangle of the tree be at X in the world, that is X = A p + b + r with r the rounding of the
// vertices. With any matrix R for the way back, R (X - b) = p + (R A - 1) p + R r, and no coordinate of p is larger
// than 1: that R is the inverse need not be proved, only that R A - 1 is small, which itself is computed with an error
// of at most five roundings of its terms.
double errorOfRow(const glm::dmat3& back, const glm::dmat3& toWorld, const glm::dvec3& rounding, int row) {
    double error = 0.0;
    for (int column = 0; column < 3; ++column) {
        double product = row == column ? -1.0 : 0.0;
        double terms = row == column ? 1.0 : 0.0;
        for (int k = 0; k < 3; ++k) {
            product += back[k][row] * toWorld[column][k];
            terms += std::fabs(back[k][row] * toWorld[column][k]);
        }
        error += std::fabs(product) + std::ldexp(terms, -50);
        error += std::fabs(back[column][row]) * rounding[column];
    }
    return error;
}

}  // namespace

std::optional<PlacedMesh> placeMesh(const glm::dmat4& toWorld, int meshExponent, int sceneExponent, const Box& box) {
    if (!isPlain(toWorld)) return std::nullopt;
    const double ofTree = powerOfTwo(meshExponent), ofScene = powerOfTwo(-sceneExponent);
    PlacedMesh placed{};
    placed.x = glm::dvec3(toWorld[0]) * ofTree;
    placed.y = glm::dvec3(toWorld[1]) * ofTree;
    placed.z = glm::dvec3(toWorld[2]) * ofTree;
    placed.origin = glm::dvec3(toWorld[3]);
    placed.shift = -sceneExponent;
    const glm::dmat3 scaled(placed.x * ofScene, placed.y * ofScene, placed.z * ofScene);
    const glm::dmat3 back = glm::inverse(scaled);
    const glm::dvec3 rounding = roundingOf(scaled, placed.origin * ofScene, box);
    double error = 0.0, norm = 0.0;
    for (int row = 0; row < 3; ++row) {
        const double ofRow = errorOfRow(back, scaled, rounding, row);
        if (!(ofRow <= kMostError)) return std::nullopt;
        error = std::max(error, ofRow);
        norm = std::max(norm, sumOfRow(back, row));
    }
    placed.inverseX = back[0];
    placed.inverseY = back[1];
    placed.inverseZ = back[2];
    placed.error = float(1.001 * error);
    placed.norm = float(1.001 * norm);
    return placed;
}

// Vertices keep their bits, but for those that fall below the smallest normal number.
PlacedMesh placeWorld(int treeExponent, int sceneExponent) {
    const int shift = treeExponent - sceneExponent;
    const double ofTree = powerOfTwo(shift), back = powerOfTwo(-shift);
    PlacedMesh placed{};
    placed.x.x = placed.y.y = placed.z.z = ofTree;
    placed.inverseX.x = placed.inverseY.y = placed.inverseZ.z = back;
    placed.shift = shift;
    placed.isWorld = 1;
    placed.error = float(std::ldexp(back, -126));
    placed.norm = float(back);
    return placed;
}

}  // namespace cleave
