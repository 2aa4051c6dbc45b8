// Loads a glTF file, builds a tree over it on the device, and shoots one ray at its middle, without any Vulkan.
#include <cleave/scene.hpp>
#include <cmath>
#include <cstdio>
#include <limits>

int main(int argc, char** argv) try {
    if (argc != 2) return std::fprintf(stderr, "usage: scene FILE\n"), 2;
    const cleave::scene::Posed posed = cleave::scene::GltfFile(argv[1]).pose();
    double middle[3] = {};
    for (const cleave::scene::Triangle& t : posed.triangles)
        for (size_t i = 0; i < t.size(); i++)
            middle[i % 3] += t[i] / (3.0 * static_cast<double>(posed.triangles.size()));

    int messages = 0;
    cleave::scene::DeviceOptions options;
    options.onValidation = [&](const char* message) {
        std::fprintf(stderr, "validation: %s\n", message);
        messages++;
    };
    cleave::scene::Device device(options);
    cleave::scene::Mesh mesh(device, posed.triangles);
    const cleave::scene::Tree tree = mesh.build();
    cleave::TraceRay ray{{}, 0.0f, {0.0f, -1.0f, 0.0f}, std::numeric_limits<float>::infinity()};
    for (int i = 0; i < 3; i++) ray.origin[i] = static_cast<float>(middle[i]) - 1000.0f * ray.direction[i];
    const cleave::scene::Answers answers = tree.trace({&ray, 1});
    const cleave::scene::Judgement judged = mesh.judge({&ray, 1}, answers.hits, cleave::Query::closest, 1);
    std::printf("%s: %u triangles, %u nodes, t %g, triangle %u\n", device.name().c_str(), tree.counts().triangles,
                tree.counts().nodes, answers.hits[0].t, answers.hits[0].prim);
    return std::isfinite(answers.hits[0].t) && judged.rays == 1 && judged.mismatches == 0 && messages == 0 ? 0 : 1;
} catch (const std::exception& error) {
    return std::fprintf(stderr, "error: %s\n", error.what()), 1;
}
