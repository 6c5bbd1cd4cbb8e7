#include "framework/files/xdmf.hpp"

#include <fmt/format.h>

#include "framework/files/number_text.hpp"

namespace dda {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// Writes the grids of the steps; holds what all of them share.
class Writer {
 public:
  explicit Writer(const XdmfSizes& sizes) : sizes_(sizes) {}

  std::string step(const XdmfStep& entry) const {
    return fmt::format(
        "      <Grid Name=\"step {}\" GridType=\"Collection\" CollectionType=\"Spatial\">\n"
        "        <Time Value=\"{}\"/>\n{}{}      </Grid>\n",
        entry.step, shortest(entry.time), blocks(entry), sizes_.segments > 0 ? segments(entry) : "");
  }

 private:
  /// `place`: FILE:/DATASET.
  static std::string item(const std::string& place, const std::string& extent, const char* type) {
    return fmt::format(
        "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"8\" Dimensions=\"{}\">{}</DataItem>", type,
        extent, escaped(place));
  }

  static std::string of_mesh(const std::string& dataset, const std::string& extent, const char* type) {
    return item(fmt::format("{}:/mesh/{}", mesh_file, dataset), extent, type);
  }

  std::string of_field(int step, const XdmfField& field) const {
    const std::size_t rows = num_places(sizes_, field.place);
    return item(fmt::format("{}:{}", step_file(step), dataset_of(field.name, field.place)),
                field.components == 1 ? std::to_string(rows) : fmt::format("{} {}", rows, field.components),
                "Float");
  }

  static std::string points(const std::string& dataset, std::size_t count) {
    return fmt::format("          <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                       of_mesh(dataset, fmt::format("{} 3", count), "Float"));
  }

  std::string blocks(const XdmfStep& entry) const {
    const std::string topology =
        fmt::format("          <Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">{}</Topology>\n",
                    sizes_.blocks, of_mesh("mixed", std::to_string(sizes_.mixed), "Int"));
    return grid("blocks", topology + points("vertices", sizes_.vertices) + region() +
                              fields(entry, FieldPlace::block, FieldPlace::block_vertex));
  }

  std::string segments(const XdmfStep& entry) const {
    const std::string topology = fmt::format(
        "          <Topology TopologyType=\"Polyline\" NodesPerElement=\"2\" NumberOfElements=\"{0}\">{1}"
        "</Topology>\n",
        sizes_.segments, of_mesh("segments", fmt::format("{} 2", sizes_.segments), "Int"));
    return grid("interfaces", topology + points("segment_ends", 2 * sizes_.segments) +
                                  fields(entry, FieldPlace::segment, FieldPlace::segment_end));
  }

  static std::string grid(const char* name, const std::string& content) {
    return fmt::format("        <Grid Name=\"{}\" GridType=\"Uniform\">\n{}        </Grid>\n", name, content);
  }

  std::string region() const {
    if (!sizes_.has_region) return "";
    return fmt::format(
        "          <Attribute Name=\"region\" AttributeType=\"Scalar\" Center=\"Cell\">{}</Attribute>\n",
        of_mesh("region", std::to_string(sizes_.blocks), "Int"));
  }

  std::string fields(const XdmfStep& entry, FieldPlace cell, FieldPlace node) const {
    std::string text;
    for (const XdmfField& field : entry.fields) {
      if (field.place != cell && field.place != node) continue;
      const std::string numbers = of_field(entry.step, field);
      text += field.labels == "n s" ? normal_and_sliding(field, numbers)
                                    : attribute(field, numbers, field.place == node);
    }
    return text;
  }

  static std::string attribute(const XdmfField& field, const std::string& numbers, bool on_nodes) {
    return fmt::format("          <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
                       escaped(field.name), kind(field.components), on_nodes ? "Node" : "Cell", numbers);
  }

  /// Two numbers, not one vector: its magnitude would call a slip an opening.
  std::string normal_and_sliding(const XdmfField& field, const std::string& numbers) const {
    const std::size_t rows = num_places(sizes_, field.place);
    std::string text;
    for (int component = 0; component < 2; ++component)
      text += fmt::format(
          "          <Attribute Name=\"{}_{}\" AttributeType=\"Scalar\" Center=\"Cell\"><DataItem "
          "ItemType=\"HyperSlab\" Dimensions=\"{} 1\"><DataItem Dimensions=\"3 2\" Format=\"XML\">0 {} 1 1 "
          "{} 1"
          "</DataItem>{}</DataItem></Attribute>\n",
          escaped(field.name), component == 0 ? "n" : "s", rows, component, rows, numbers);
    return text;
  }

  static const char* kind(int components) {
    if (components == 1) return "Scalar";
    return components == 3 ? "Vector" : "Matrix";
  }

  XdmfSizes sizes_;
};

}  // namespace

std::size_t num_places(const XdmfSizes& sizes, FieldPlace place) {
  switch (place) {
    case FieldPlace::block:
      return sizes.blocks;
    case FieldPlace::block_vertex:
      return sizes.vertices;
    case FieldPlace::segment:
      return sizes.segments;
    case FieldPlace::segment_end:
      return 2 * sizes.segments;
  }
  return 0;
}

std::string xdmf_text(const XdmfSizes& sizes, const std::vector<XdmfStep>& steps) {
  const Writer writer(sizes);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Xdmf Version=\"2.2\">\n  <Domain>\n"
      "    <Grid Name=\"path\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const XdmfStep& step : steps) text += writer.step(step);
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}  // namespace dda
