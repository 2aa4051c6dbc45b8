// Fetches the triangles of the geometries that a tree is built over.

uint triangleNumber(uint index) { return args.numberCount != 0u ? args.list.at[index] : index; }

// The last geometry that begins at or below a triangle's number.
GeometryData geometryOf(uint number) {
    uint low = 0u;
    uint high = args.geometryCount;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (args.geometries.at[middle].firstTriangle <= number) low = middle;
        else high = middle;
    }
    return args.geometries.at[low];
}

uint vertexIndex(GeometryData g, uint corner) {
    if (g.indexBits == 32u) return g.indices.at[corner];
    if (g.indexBits == 16u) return g.indices.at[corner >> 1] >> (16u * (corner & 1u)) & 0xFFFFu;
    return corner;
}

// A vertex that is not there is not finite.
vec3 worldVertex(GeometryData g, uint corner) {
    uint v = vertexIndex(g, corner);
    if (v >= g.vertexCount) return vec3(infinity());
    uint at = v * g.stride;
    vec3 p = vec3(g.vertices.at[at], g.vertices.at[at + 1u], g.vertices.at[at + 2u]);
    if (g.hasTransform == 0u) return p;
    vec3 q;
    for (uint row = 0u; row < 3u; row++) {
        uint m = 4u * row;
        q[row] = float(transformedBy(g.transform.at[m], g.transform.at[m + 1u], g.transform.at[m + 2u],
                                     g.transform.at[m + 3u], dvec3(p)));
    }
    return q;
}

Triangle worldTriangle(uint number) {
    GeometryData g = geometryOf(number);
    uint corner = 3u * (number - g.firstTriangle);
    Triangle t;
    t.a = worldVertex(g, corner);
    t.b = worldVertex(g, corner + 1u);
    t.c = worldVertex(g, corner + 2u);
    return t;
}
