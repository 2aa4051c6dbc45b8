// The surface at a hit: what materials, textures and the corners of triangles make of it.
#ifndef CLEAVE_SHARED_SURFACE_H
#define CLEAVE_SHARED_SURFACE_H
#include "shade.h"

#include "material.h"
#include "sampling.h"

CLEAVE_BEGIN

// Which parts a scene has; kernels are compiled without the others.
CLEAVE_CONST uint kPartNormals = 1u;   // at corners
CLEAVE_CONST uint kPartColours = 2u;   // at corners
CLEAVE_CONST uint kPartTextures = 4u;  // with their coordinates
CLEAVE_CONST uint kPartVariants = 8u;  // of sets of parts

CLEAVE_TABLE(Vec2Array, vec2);
CLEAVE_TABLE(Vec3Array, vec3);
CLEAVE_TABLE(Vec4Array, vec4);
CLEAVE_TABLE(NumberArray, uint);

// What surfaces are made of: name, element, its array, the part that it is for (0: it is there always). Those of
// corners hold three entries for each triangle; see CornerAttributes in scene/pose.h.
#define CLEAVE_SURFACE_ARRAYS(ROW)                                                              \
    ROW(surfaceOf, uint, NumberArray, 0u) /* of each triangle: a material, perhaps with bits */ \
    ROW(materials, Material, MaterialArray, 0u)                                                 \
    ROW(normals, vec3, Vec3Array, kPartNormals)                                                 \
    ROW(colours, vec4, Vec4Array, kPartColours)                                                 \
    ROW(texCoords0, vec2, Vec2Array, kPartTextures)                                             \
    ROW(texCoords1, vec2, Vec2Array, kPartTextures)                                             \
    ROW(maps, TextureMap, TextureMapArray, kPartTextures)                                       \
    ROW(texels, uint, TexelArray, kPartTextures)

#define CLEAVE_SURFACE_MEMBER(name, Element, Array, part) Array name;
struct SurfaceArrays {
    CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_MEMBER)
};
#undef CLEAVE_SURFACE_MEMBER

struct HitSurface {
    vec3 facing;      // the triangle's unit normal on the side that the ray comes from
    vec3 normal;      // of shading, in the hemisphere of `facing`
    vec4 baseColour;  // linear
    vec3 emission;
    float brightness;  // of the material
    float metallic;
    float roughness;
    float occlusion;  // share of the light from all around that reaches the point: 1 where nothing is near
    uint flags;       // of the material
};

CLEAVE_FN Material materialOf(SurfaceArrays s, uint triangle) {
    return s.materials.at[materialNumber(s.surfaceOf.at[triangle])];
}

CLEAVE_FN vec2 cornerCoordinates(SurfaceArrays s, TextureMap map, uint corner) {
    if ((map.flags & kMapAtOrigin) != 0u) return vec2(0.0f, 0.0f);
    return (map.flags & kMapSecondSet) != 0u ? s.texCoords1.at[corner] : s.texCoords0.at[corner];
}

CLEAVE_FN vec4 mapped(SurfaceArrays s, uint number, Hit hit) {
    TextureMap map = s.maps.at[number];
    uint corner = 3u * hit.prim;
    vec2 a = cornerCoordinates(s, map, corner);
    vec2 b = cornerCoordinates(s, map, corner + 1u);
    vec2 c = cornerCoordinates(s, map, corner + 2u);
    return sampledTexture(s.texels, map, a + (b - a) * hit.u + (c - a) * hit.v);
}

CLEAVE_FN vec4 baseColourAt(SurfaceArrays s, uint parts, Material m, Hit hit) {
    vec4 colour = m.baseColour;
    if ((parts & kPartTextures) != 0u && m.baseColourMap != kNone) colour = colour * mapped(s, m.baseColourMap, hit);
    if ((parts & kPartColours) != 0u) {
        uint corner = 3u * hit.prim;
        vec4 a = s.colours.at[corner];
        colour = colour * (a + (s.colours.at[corner + 1u] - a) * hit.u + (s.colours.at[corner + 2u] - a) * hit.v);
    }
    return colour;
}

// Whether a ray of the direction comes to the front of a triangle: the side from which its vertices go
// counterclockwise, unless it is mirrored; any side of one that has no back.
CLEAVE_FN bool comesToFront(SurfaceArrays s, uint triangle, Triangle world, vec3 direction) {
    dvec3 a = dvec3(world.a);
    dvec3 normal = preciseCross(dvec3(world.b) - a, dvec3(world.c) - a);
    bool counterclockwise = preciseDot(normal, dvec3(direction)) < double(0.0f);
    uint surface = s.surfaceOf.at[triangle];
    return (surface & kNoBack) != 0u || counterclockwise == ((surface & kMirrored) == 0u);
}

// Whether a ray finds the surface where it meets the triangle. `chance` is a random number in [0, 1) for the two.
CLEAVE_FN bool isThere(SurfaceArrays s, uint parts, Material m, Hit hit, float chance) {
    if (isOpaque(m)) return true;
    float alpha = baseColourAt(s, parts, m, hit).w;
    return (m.flags & kMaterialMask) != 0u ? alpha >= m.alphaCutoff : chance < alpha;
}

// And how often it does.
CLEAVE_FN float presenceAt(SurfaceArrays s, uint parts, Material m, Hit hit) {
    if (isOpaque(m)) return 1.0f;
    float alpha = baseColourAt(s, parts, m, hit).w;
    if ((m.flags & kMaterialMask) != 0u) return alpha >= m.alphaCutoff ? 1.0f : 0.0f;
    return min(max(alpha, 0.0f), 1.0f);
}

CLEAVE_FN vec3 emissionAt(SurfaceArrays s, uint parts, Material m, Hit hit) {
    if ((parts & kPartTextures) == 0u || m.emissionMap == kNone) return m.emission;
    vec4 texel = mapped(s, m.emissionMap, hit);
    return m.emission * vec3(texel.x, texel.y, texel.z);
}

// v of length 1; `otherwise` where it has none.
CLEAVE_FN vec3 unitOr(vec3 v, vec3 otherwise) {
    float size = largestComponent(v);
    if (!(size > kSmallestNormal && isFinite(size))) return otherwise;
    return unitVector(v * (1.0f / size));
}

// The normal between those of the corners, and whether the ray sees the front: the side that these point to or, where
// corners have none, the front of the triangle.
struct SmoothNormal {
    vec3 normal;
    bool front;
};

CLEAVE_FN SmoothNormal smoothNormal(SurfaceArrays s, uint parts, Hit hit, Triangle t, vec3 facing) {
    SmoothNormal r;
    vec3 across = unitOr(t.b - t.a, facing);
    vec3 along = unitOr(t.c - t.a, facing);
    vec3 own = preciseCross(across, along);
    uint corner = 3u * hit.prim;
    vec3 a = vec3(0.0f, 0.0f, 0.0f);
    if ((parts & kPartNormals) != 0u) a = s.normals.at[corner];
    if (largestComponent(a) > 0.0f) {
        own = unitOr(a + (s.normals.at[corner + 1u] - a) * hit.u + (s.normals.at[corner + 2u] - a) * hit.v, own);
        r.front = dotOf(own, facing) >= 0.0f;
        r.normal = r.front ? own : own * -1.0f;
        return r;
    }
    r.front = (dotOf(own, facing) >= 0.0f) == ((s.surfaceOf.at[hit.prim] & kMirrored) == 0u);
    r.normal = facing;
    return r;
}

// The normal that a normal map bends the normal `between` the corners' to. Tangents follow the texture's coordinates
// across the triangle: x points to where u grows, y to where v falls, since images begin at their top.
CLEAVE_FN vec3 bentNormal(SurfaceArrays s, Material m, Hit hit, Triangle t, SmoothNormal between) {
    TextureMap map = s.maps.at[m.normalMap];
    uint corner = 3u * hit.prim;
    vec2 a = cornerCoordinates(s, map, corner);
    vec2 b = cornerCoordinates(s, map, corner + 1u) - a;
    vec2 c = cornerCoordinates(s, map, corner + 2u) - a;
    float turn = b.x * c.y - c.x * b.y < 0.0f ? -1.0f : 1.0f;
    vec3 e1 = t.b - t.a;
    vec3 e2 = t.c - t.a;
    vec3 alongU = (e1 * c.y - e2 * b.y) * turn;
    vec3 alongV = (e2 * b.x - e1 * c.x) * turn;
    vec3 n = between.normal;
    vec3 tangent = unitOr(alongU, basisAbout(n).x);
    tangent = unitOr(tangent - n * dotOf(n, tangent), basisAbout(n).x);
    vec3 other = preciseCross(n, tangent);
    if (dotOf(other, unitOr(alongV, other * -1.0f)) > 0.0f) other = other * -1.0f;
    vec4 texel = sampledTexture(s.texels, map, a + b * hit.u + c * hit.v);
    float side = between.front ? m.normalScale : -m.normalScale;
    vec3 bent = tangent * ((2.0f * texel.x - 1.0f) * side) + other * ((2.0f * texel.y - 1.0f) * side) +
                n * max(2.0f * texel.z - 1.0f, 0.0f);
    return unitOr(bent, n);
}

// `t` is the triangle in the scaled space of the tree, since there it neither overflows nor vanishes.
CLEAVE_FN HitSurface hitSurface(SurfaceArrays s, uint parts, Hit hit, Triangle t, vec3 direction) {
    Material m = materialOf(s, hit.prim);
    HitSurface p;
    p.facing = facingNormal(t, direction);
    p.normal = p.facing;
    p.baseColour = baseColourAt(s, parts, m, hit);
    p.emission = emissionAt(s, parts, m, hit);
    p.brightness = m.brightness;
    p.metallic = m.metallic;
    p.roughness = m.roughness;
    p.occlusion = 1.0f;
    p.flags = m.flags;
    bool bends = (parts & kPartTextures) != 0u && m.normalMap != kNone;
    if (bends || (parts & kPartNormals) != 0u) {
        SmoothNormal between = smoothNormal(s, parts, hit, t, p.facing);
        p.normal = between.normal;
        if (bends) p.normal = bentNormal(s, m, hit, t, between);
    }
    if ((parts & kPartTextures) != 0u) {
        if (m.metallicRoughnessMap != kNone) {
            vec4 texel = mapped(s, m.metallicRoughnessMap, hit);
            p.roughness = p.roughness * texel.y;
            p.metallic = p.metallic * texel.z;
        }
        if (m.occlusionMap != kNone) {
            float found = mapped(s, m.occlusionMap, hit).x;
            p.occlusion = 1.0f + m.occlusionStrength * (found - 1.0f);
        }
    }
    return p;
}

// Linear light that a surface sends back in the view `shaded`, where the sun, in that direction, shines on it or does
// not, and the light from all around reaches it or does not.
CLEAVE_FN vec3 shadedColour(HitSurface p, vec3 towardsLight, bool lit, bool open) {
    vec3 base = vec3(p.baseColour.x, p.baseColour.y, p.baseColour.z);
    if ((p.flags & kMaterialUnlit) != 0u) return base;
    bool faces = dotOf(p.facing, towardsLight) > 0.0f;
    float sun = lit && faces ? kSunLight * max(dotOf(p.normal, towardsLight), 0.0f) : 0.0f;
    vec3 around = mixed(vec3(0.16f, 0.15f, 0.14f), vec3(0.30f, 0.33f, 0.38f), 0.5f + 0.5f * p.normal.y);
    vec3 ambient = scaledBy(around, open ? p.occlusion : 0.0f);
    return vec3(base.x * (ambient.x + sun), base.y * (ambient.y + sun * 0.97f), base.z * (ambient.z + sun * 0.90f)) +
           p.emission;
}

CLEAVE_END
#endif
