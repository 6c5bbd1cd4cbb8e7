#include "framework/files/run/xdmf.hpp"

#include <fmt/format.h>

#include <cmath>

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
        "        <Time Value=\"{}\"/>\n{}{}{}{}      </Grid>\n",
        entry.step, shortest(entry.time), blocks(entry), sizes_.segments > 0 ? segments(entry) : "",
        entry.cuts.parts > 0 ? parts(entry) : "", entry.cuts.pieces > 0 ? cracks(entry) : "");
  }

 private:
  /// `place`: FILE:/DATASET.
  static std::string item(const std::string& place, const std::string& extent, const char* type) {
    return fmt::format(
        "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"8\" Dimensions=\"{}\">{}</DataItem>", type,
        extent, escaped(place));
  }

  static std::string of_mesh(const std::string& dataset) {
    return fmt::format("{}:/mesh/{}", mesh_file, dataset);
  }
  static std::string of_step(const XdmfStep& entry, const std::string& dataset) {
    return fmt::format("{}:{}", step_file(entry.step), dataset);
  }

  static std::string points(const std::string& place, std::size_t count) {
    return fmt::format("          <Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                       item(place, fmt::format("{} 3", count), "Float"));
  }

  static std::string polygons(const std::string& place, std::size_t count, std::size_t size) {
    return fmt::format("          <Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">{}</Topology>\n",
                       count, item(place, std::to_string(size), "Int"));
  }

  static std::string lines(const std::string& place, std::size_t count) {
    return fmt::format(
        "          <Topology TopologyType=\"Polyline\" NodesPerElement=\"2\" NumberOfElements=\"{0}\">{1}"
        "</Topology>\n",
        count, item(place, fmt::format("{} 2", count), "Int"));
  }

  std::string blocks(const XdmfStep& entry) const {
    const std::string topology =
        entry.cuts.parts > 0 ? polygons(of_step(entry, "/parts/whole"), sizes_.blocks, entry.cuts.whole)
                             : polygons(of_mesh("mixed"), sizes_.blocks, sizes_.mixed);
    return grid("blocks", topology + points(of_mesh("vertices"), sizes_.vertices) + numbers(entry) +
                              region() + fields(entry, FieldPlace::block, FieldPlace::block_vertex));
  }

  std::string segments(const XdmfStep& entry) const {
    return grid("interfaces", lines(of_mesh("segments"), sizes_.segments) +
                                  points(of_mesh("segment_ends"), 2 * sizes_.segments) +
                                  fields(entry, FieldPlace::segment, FieldPlace::segment_end));
  }

  std::string parts(const XdmfStep& entry) const {
    const XdmfCuts& cuts = entry.cuts;
    return grid("parts",
                polygons(of_step(entry, "/parts/mixed"), cuts.parts, cuts.mixed) +
                    points(of_step(entry, "/parts/vertices"), cuts.vertices) +
                    number("block", of_step(entry, "/parts/block"), cuts.parts) +
                    (sizes_.has_region ? number("region", of_step(entry, "/parts/region"), cuts.parts) : "") +
                    fields(entry, FieldPlace::part, FieldPlace::part_vertex));
  }

  std::string cracks(const XdmfStep& entry) const {
    const std::size_t count = entry.cuts.pieces;
    return grid("cracks", lines(of_step(entry, "/cracks/lines"), count) +
                              points(of_step(entry, "/cracks/ends"), 2 * count) +
                              number("crack", of_step(entry, "/cracks/crack"), count) +
                              number("is_provisional", of_step(entry, "/cracks/is_provisional"), count) +
                              fields(entry, FieldPlace::crack, FieldPlace::crack_end));
  }

  static std::string grid(const char* name, const std::string& content) {
    return fmt::format("        <Grid Name=\"{}\" GridType=\"Uniform\">\n{}        </Grid>\n", name, content);
  }

  /// Whole numbers, one per cell.
  static std::string number(const char* name, const std::string& place, std::size_t count) {
    return fmt::format(
        "          <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Cell\">{}</Attribute>\n", name,
        item(place, std::to_string(count), "Int"));
  }

  std::string region() const {
    return sizes_.has_region ? number("region", of_mesh("region"), sizes_.blocks) : "";
  }

  /// One for the whole grid. Xdmf2 reads "nan" as garbage.
  static std::string field_data(const std::string& name, double value) {
    if (!std::isfinite(value)) return "";
    return fmt::format(
        "          <Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Grid\"><DataItem Format=\"XML\" "
        "NumberType=\"Float\" Precision=\"8\" Dimensions=\"1\">{}</DataItem></Attribute>\n",
        escaped(name), shortest(value));
  }

  std::string numbers(const XdmfStep& entry) const {
    std::string text;
    for (const auto& [name, value] : entry.numbers) text += field_data(name, value);
    for (std::size_t i = 0; i < sizes_.regions.size(); ++i)
      text += field_data(fmt::format("region {}: {}", i, sizes_.regions[i]), static_cast<double>(i));
    return text;
  }

  std::string fields(const XdmfStep& entry, FieldPlace cell, FieldPlace node) const {
    std::string text;
    for (const XdmfField& field : entry.fields) {
      if (field.place != cell && field.place != node) continue;
      // Not one vector: its magnitude would call a slip an opening.
      if (field.labels == normal_and_sliding)
        for (const char* component : {"_n", "_s"})
          text += attribute(entry, {field.name + component, field.place, 1}, field.name + component);
      else if (is_tensor(field.labels))
        text += attribute(entry, {field.name, field.place, 9}, tensor_of(field.name));
      else
        text += attribute(entry, field, field.name);
    }
    return text;
  }

  std::string attribute(const XdmfStep& entry, const XdmfField& field, const std::string& dataset) const {
    const std::size_t rows = num_places(sizes_, entry.cuts, field.place);
    const std::string extent =
        field.components == 1 ? std::to_string(rows) : fmt::format("{} {}", rows, field.components);
    return fmt::format("          <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
                       escaped(field.name), kind(field.components),
                       is_on_nodes(field.place) ? "Node" : "Cell",
                       item(of_step(entry, dataset_of(dataset, field.place)), extent, "Float"));
  }

  static bool is_on_nodes(FieldPlace place) {
    return place == FieldPlace::block_vertex || place == FieldPlace::segment_end ||
           place == FieldPlace::part_vertex || place == FieldPlace::crack_end;
  }

  static const char* kind(int components) {
    if (components == 1) return "Scalar";
    if (components == 9) return "Tensor";
    return components == 3 ? "Vector" : "Matrix";
  }

  XdmfSizes sizes_;
};

}  // namespace

std::size_t num_places(const XdmfSizes& sizes, const XdmfCuts& cuts, FieldPlace place) {
  switch (place) {
    case FieldPlace::block:
      return sizes.blocks;
    case FieldPlace::block_vertex:
      return sizes.vertices;
    case FieldPlace::segment:
      return sizes.segments;
    case FieldPlace::segment_end:
      return 2 * sizes.segments;
    case FieldPlace::part:
      return cuts.parts;
    case FieldPlace::part_vertex:
      return cuts.vertices;
    case FieldPlace::crack:
      return cuts.pieces;
    case FieldPlace::crack_end:
      return 2 * cuts.pieces;
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
