#include "scene/draco_decoder.h"

#include <draco/compression/entropy/symbol_decoding.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>

#include <memory>

#include "scene/refuse.h"

namespace cleave {
namespace {

// Encoders make one attribute of each that glTF has.
constexpr int kMostAttributes = 64;

// Connectivity takes about so much for each triangle, and again for each set of seams.
constexpr uint64_t kBytesPerTriangle = 64;

struct Announced {
    uint64_t triangles = 0;
    uint64_t seams = 0;  // sets of attributes with edges of their own
};

// What is refused while the library is at work, which throws no exceptions of its own.
class Limits {
  public:
    explicit Limits(const DracoRequest& request) : request_(request) {}
    const std::string& complaint() const { return complaint_; }

    bool allowConnectivity(const Announced& announced) {
        if (request_.indices && announced.triangles * 3 != *request_.indices)
            return complain(std::to_string(announced.triangles) + " triangles, and its accessor has " +
                            std::to_string(*request_.indices) + " indices");
        return allowBytes(announced.triangles * kBytesPerTriangle * (1 + announced.seams));
    }

    // The values of attributes are not there yet.
    bool allowAttributes(const draco::PointCloud& cloud) {
        const uint64_t vertices = cloud.num_points();
        if (request_.vertices && vertices != *request_.vertices)
            return complain(std::to_string(vertices) + " vertices, and its accessors have " +
                            std::to_string(*request_.vertices));
        if (cloud.num_attributes() > kMostAttributes)
            return complain(std::to_string(cloud.num_attributes()) + " attributes, and " +
                            std::to_string(kMostAttributes) + " is the most that is allowed");
        uint64_t each = 0;
        for (int i = 0; i < cloud.num_attributes(); ++i) {
            const draco::PointAttribute& attribute = *cloud.attribute(i);
            const int length = draco::DataTypeLength(attribute.data_type());
            if (length <= 0) return complain("an attribute of a type that is not known");
            each += attribute.num_components() * (uint64_t(length) + sizeof(int32_t));
        }
        return allowBytes(vertices * each);
    }

    // Takes a count of orientations, of which a value has one at most.
    bool allowOrientations(int64_t count, size_t values) {
        return (count >= 0 && uint64_t(count) <= values) ||
               complain(std::to_string(count) + " orientations for " + std::to_string(values) + " values");
    }
    bool complain(const std::string& what) {
        complaint_ = " has " + what;
        return false;
    }

  private:
    bool allowBytes(uint64_t bytes) {
        return bytes <= request_.mostBytes ||
               complain("so many triangles and attributes that they take " + std::to_string(bytes) + " bytes, and " +
                        std::to_string(request_.mostBytes) + " is the most that is left for the scene");
    }

    const DracoRequest& request_;
    std::string complaint_;
};

// Reads the counts at the beginning of the connectivity, which the decoder has not come to yet. Draco's bitstream
// specification, sections 5.1 (ParseEdgebreakerConnectivityData) and 4.1 (DecodeSequentialConnectivityData).
bool peek(draco::DecoderBuffer buffer, const draco::MeshEdgebreakerDecoder&, Announced& announced) {
    uint32_t vertices = 0;
    uint32_t triangles = 0;
    uint8_t seams = 0;
    const bool good =
        draco::DecodeVarint(&vertices, &buffer) && draco::DecodeVarint(&triangles, &buffer) && buffer.Decode(&seams);
    announced = {triangles, seams};
    return good;
}

bool peek(draco::DecoderBuffer buffer, const draco::MeshSequentialDecoder&, Announced& announced) {
    uint32_t triangles = 0;
    const bool good = draco::DecodeVarint(&triangles, &buffer);
    announced = {triangles, 0};
    return good;
}

// Skips the corrections of predicted whole numbers (SequentialIntegerAttributeDecoder::DecodeIntegerValues).
bool skipCorrections(draco::DecoderBuffer& buffer, size_t values, int components) {
    const size_t numbers = values * size_t(components);
    uint8_t isCompressed = 0;
    uint8_t size = 0;
    if (!buffer.Decode(&isCompressed)) return false;
    if (isCompressed > 0) {
        std::vector<uint32_t> symbols(numbers);
        return draco::DecodeSymbols(uint32_t(numbers), components, &buffer, symbols.data());
    }
    if (!buffer.Decode(&size) || uint64_t(buffer.remaining_size()) < size * numbers) return false;
    buffer.Advance(int64_t(size * numbers));
    return true;
}

// Looks at the data of a prediction scheme, whose number is the byte before the last one that was read. The library
// takes any count of the orientations of texture coordinates, and is busy for a minute with 2^31 of them.
bool isBounded(draco::DecoderBuffer buffer, const draco::PointAttribute& attribute, size_t values, Limits& limits) {
    if (buffer.decoded_size() < 2) return true;
    const int8_t scheme = buffer.data_head()[-2];
    if (scheme == draco::MESH_PREDICTION_TEX_COORDS_DEPRECATED)
        return limits.complain("texture coordinates by a prediction that is no longer written");
    int32_t orientations = 0;
    if (scheme != draco::MESH_PREDICTION_TEX_COORDS_PORTABLE ||
        !skipCorrections(buffer, values, attribute.num_components()) || !buffer.Decode(&orientations))
        return true;  // the library finds what is wrong
    return limits.allowOrientations(orientations, values);
}

// A decoder of the library that stops where the limits say so.
template <typename Decoder>
class LimitedDecoder : public Decoder {
  public:
    explicit LimitedDecoder(Limits& limits) : limits_(limits) {}

    // The library asks for this when it has read the number of a prediction scheme, and nothing of its data.
    const draco::MeshAttributeIndicesEncodingData* GetAttributeEncodingData(int id) const override {
        const auto* data = Decoder::GetAttributeEncodingData(id);
        draco::DecoderBuffer& buffer = *const_cast<LimitedDecoder*>(this)->buffer();
        if (data != nullptr && !isBounded(buffer, *this->point_cloud()->attribute(id),
                                          data->encoded_attribute_value_index_to_corner_map.size(), limits_))
            buffer.Advance(buffer.remaining_size());  // whatever it reads next fails
        return data;
    }

  protected:
    bool DecodeConnectivity() override {
        Announced announced;
        return peek(*this->buffer(), *this, announced) && limits_.allowConnectivity(announced) &&
               Decoder::DecodeConnectivity();
    }
    bool DecodeAllAttributes() override {
        return limits_.allowAttributes(*this->point_cloud()) && Decoder::DecodeAllAttributes();
    }

  private:
    Limits& limits_;
};

std::unique_ptr<draco::MeshDecoder> decoderOf(const draco::DracoHeader& header, Limits& limits) {
    if (header.encoder_type != draco::TRIANGULAR_MESH) return nullptr;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING)
        return std::make_unique<LimitedDecoder<draco::MeshEdgebreakerDecoder>>(limits);
    if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING)
        return std::make_unique<LimitedDecoder<draco::MeshSequentialDecoder>>(limits);
    return nullptr;
}

draco::DecoderBuffer bufferOf(std::span<const unsigned char> bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return buffer;
}

}  // namespace

void decodeDraco(std::span<const unsigned char> bytes, const DracoRequest& request, const std::string& where,
                 draco::Mesh& mesh) {
    draco::DecoderBuffer start = bufferOf(bytes);
    draco::DracoHeader header{};
    if (!draco::PointCloudDecoder::DecodeHeader(&start, &header).ok()) refuseGltf(where + " is no Draco data");
    if (header.version_major != draco::kDracoMeshBitstreamVersionMajor ||
        header.version_minor != draco::kDracoMeshBitstreamVersionMinor)
        refuseGltf(where + " is of Draco's version " + std::to_string(header.version_major) + "." +
                       std::to_string(header.version_minor) + ", and KHR_draco_mesh_compression means 2.2",
                   "compress it once more");
    Limits limits(request);
    const std::unique_ptr<draco::MeshDecoder> decoder = decoderOf(header, limits);
    if (decoder == nullptr) refuseGltf(where + " is Draco data, and no mesh");
    draco::DecoderBuffer buffer = bufferOf(bytes);
    const draco::Status status = decoder->Decode(draco::DecoderOptions(), &buffer, &mesh);
    if (!limits.complaint().empty()) refuseGltf(where + limits.complaint());
    if (!status.ok()) refuseGltf(where + " cannot be decompressed by Draco: it is broken");
}

}  // namespace cleave
