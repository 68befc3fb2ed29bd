// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/random_gltf.hpp"

#include <cmath>
#include <vector>

#include "base/numbers/bits.hpp"
#include "base/numbers/numbers.hpp"
#include "smurf/pose.hpp"
#include "write/text/base64.hpp"

namespace smurf::test {
namespace {

class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  GltfFile run() {
    buffers_.resize(1 + random_.below(2));
    const std::size_t meshes = 1 + random_.below(3);
    std::string all;
    for (std::size_t i = 0; i < meshes; ++i) all += (i > 0 ? "," : "") + mesh();
    const std::size_t roots = 1 + random_.below(3);
    std::string scene;
    for (std::size_t i = 0; i < roots; ++i) {
      scene += (i > 0 ? "," : "") + std::to_string(node(meshes, 0));
    }
    const bool is_binary = random_.one_in(3);
    GltfFile file{is_binary ? "m.glb" : "m.gltf", {}, {}};
    std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + scene +
                       "]}],\"nodes\":[" + joined(nodes_) + "],\"meshes\":[" + all +
                       "],\"accessors\":[" + joined(accessors_) + "],\"bufferViews\":[" +
                       joined(views_) + "],\"buffers\":[";
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
      json += (i > 0 ? "," : "") + ("{\"byteLength\":" + std::to_string(buffers_[i].size()));
      if (i > 0 || !is_binary) json += ",\"uri\":\"" + uri(i, file) + "\"";
      json += "}";
    }
    json += "]}";
    file.bytes = is_binary ? gltf_binary(json, buffers_[0]) : json;
    return file;
  }

 private:
  static std::string joined(const std::vector<std::string>& items) {
    std::string out;
    for (const std::string& item : items) out += (out.empty() ? "" : ",") + item;
    return out;
  }

  std::string uri(std::size_t index, GltfFile& file) {
    if (random_.one_in(2)) {
      return "data:application/octet-stream;base64," + base64(buffers_[index]);
    }
    const std::string name = "buffer" + std::to_string(index) + ".bin";
    file.beside[name] = buffers_[index];
    return name;
  }

  std::string numbers(std::size_t count, double low, double high) {
    std::string out = "[";
    for (std::size_t i = 0; i < count; ++i) {
      out += (i > 0 ? "," : "") + format_number(random_.between(low, high));
    }
    return out + "]";
  }

  /// The index of a new view of the bytes.
  std::size_t view(const std::string& bytes, std::size_t stride) {
    const std::size_t place = random_.below(buffers_.size());
    std::string& buffer = buffers_[place];
    buffer.append(4 * random_.below(3), '\7');
    const std::size_t offset = buffer.size();
    buffer += bytes;
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    views_.push_back("{\"buffer\":" + std::to_string(place) + ",\"byteOffset\":" +
                     std::to_string(offset) + ",\"byteLength\":" + std::to_string(bytes.size()) +
                     (stride > 0 ? ",\"byteStride\":" + std::to_string(stride) : "") + "}");
    return views_.size() - 1;
  }

  std::size_t accessor(std::size_t view, std::size_t offset, std::size_t type, std::size_t count,
                       const std::string& rest) {
    accessors_.push_back("{\"bufferView\":" + std::to_string(view) + ",\"byteOffset\":" +
                         std::to_string(offset) + ",\"componentType\":" + std::to_string(type) +
                         ",\"count\":" + std::to_string(count) + "," + rest + "}");
    return accessors_.size() - 1;
  }

  std::size_t points(std::size_t count) {
    const std::size_t before = 4 * random_.below(3);
    const std::size_t stride = 12 + 4 * random_.below(3) + before;
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) {
      std::string point(before, '\1');
      for (std::size_t k = 0; k < 3; ++k) {
        append_bytes(point, bit_cast<std::uint32_t>(static_cast<float>(random_.between(-5, 5))));
      }
      point.resize(stride, '\2');
      bytes += point;
    }
    return accessor(view(bytes, stride == 12 ? 0 : stride), before, 5126, count,
                    R"("type":"VEC3","min":[-5,-5,-5],"max":[5,5,5])");
  }

  std::string indices(std::size_t count, std::size_t points) {
    const std::size_t size = std::size_t{1} << random_.below(3);
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) {
      // Neighbours in a strip differ, because assimp leaves out degenerate triangles.
      const std::uint32_t index = static_cast<std::uint32_t>((i * 7 + i / points) % points);
      for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(index >> (8 * k) & 0xffU);
    }
    const std::size_t type = size == 1 ? 5121 : size == 2 ? 5123 : 5125;
    return ",\"indices\":" +
           std::to_string(accessor(view(bytes, 0), 0, type, count, R"("type":"SCALAR")"));
  }

  std::string mesh() {
    std::string all;
    const std::size_t number = 1 + random_.below(3);
    for (std::size_t i = 0; i < number; ++i) {
      const std::size_t mode = 4 + random_.below(3);
      const std::size_t triangles = 1 + random_.below(6);
      const std::size_t corners = mode == 4 ? 3 * triangles : triangles + 2;
      const bool is_indexed = !random_.one_in(3);
      constexpr std::size_t kPoints = 11;  // with a step of 7, all indices are different
      const std::size_t count = is_indexed ? kPoints : corners;
      all += (i > 0 ? ",{" : "{");
      all += "\"attributes\":{\"POSITION\":" + std::to_string(points(count)) + "}";
      if (mode != 4 || random_.one_in(2)) all += ",\"mode\":" + std::to_string(mode);
      if (is_indexed) all += indices(corners, kPoints);
      all += "}";
    }
    return "{\"primitives\":[" + all + "]}";
  }

  std::size_t node(std::size_t meshes, std::size_t depth) {
    std::string children;
    for (std::size_t i = depth < 3 ? random_.below(3) : 0; i > 0; --i) {
      children += (children.empty() ? "" : ",") + std::to_string(node(meshes, depth + 1));
    }
    std::string out = "{\"name\":\"n" + std::to_string(nodes_.size()) + "\"";
    if (random_.one_in(3)) {
      out += ",\"matrix\":[1,0.5,-0.25,0,0,2,1,0,-1,0,0.5,0,3,-4,5,1]";
    } else {
      if (random_.one_in(2)) out += ",\"translation\":" + numbers(3, -9, 9);
      if (random_.one_in(2)) out += ",\"rotation\":" + rotation();
      if (random_.one_in(2)) out += ",\"scale\":" + numbers(3, 0.3, 3);
    }
    if (depth == 0 || random_.one_in(2))
      out += ",\"mesh\":" + std::to_string(random_.below(meshes));
    if (!children.empty()) out += ",\"children\":[" + children + "]";
    nodes_.push_back(out + "}");
    return nodes_.size() - 1;
  }

  std::string rotation() {
    const Quaternion q =
        from_rpy({random_.between(-3, 3), random_.between(-1.5, 1.5), random_.between(-3, 3)});
    return "[" + format_number(q.x) + "," + format_number(q.y) + "," + format_number(q.z) + "," +
           format_number(q.w) + "]";
  }

  Random& random_;
  std::vector<std::string> buffers_, views_, accessors_, nodes_;
};

}  // namespace

std::string gltf_binary(const std::string& json, const std::string& buffer) {
  const auto chunk = [](std::string bytes, std::uint32_t type, char fill) {
    bytes.resize((bytes.size() + 3) / 4 * 4, fill);
    std::string out;
    append_bytes(out, static_cast<std::uint32_t>(bytes.size()));
    append_bytes(out, type);
    return out + bytes;
  };
  const std::string chunks =
      chunk(json, 0x4e4f534aU, ' ') + (buffer.empty() ? "" : chunk(buffer, 0x004e4942U, '\0'));
  std::string file = "glTF";
  append_bytes(file, std::uint32_t{2});
  append_bytes(file, static_cast<std::uint32_t>(chunks.size() + 12));
  return file + chunks;
}

GltfFile random_gltf(Random& random) { return Writer(random).run(); }

}  // namespace smurf::test
