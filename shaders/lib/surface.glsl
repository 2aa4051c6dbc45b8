// The surfaces of a scene, as the kernels of a picture find them in `args`, their PictureArgs.
#ifndef CLEAVE_LIB_SURFACE
#define CLEAVE_LIB_SURFACE

// Which parts the scene has, kPartNormals and so on. The constants before it are those of lib/trace_main.glsl.
layout(constant_id = 3) const uint kParts = 0u;

SurfaceArrays surfaceArrays() {
    SurfaceArrays s;
#define CLEAVE_SURFACE_COPY(name, Element, Array, part) s.name = args.name;
    CLEAVE_SURFACE_ARRAYS(CLEAVE_SURFACE_COPY)
#undef CLEAVE_SURFACE_COPY
    return s;
}
#endif
