#include "studies/dda/figures/model_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "framework/figure/drawing.hpp"
#include "framework/figure/style.hpp"
#include "framework/files/whole_file.hpp"
#include "models/equilibrium/loading.hpp"
#include "models/load/eigenstress.hpp"
#include "studies/dda/figures/material_colours.hpp"
#include "studies/dda/figures/model_marks.hpp"
#include "studies/dda/figures/pictures.hpp"

namespace dda {
namespace {

using svg::KeyEntry;
using svg::Mark;

/// Adds part after part to the drawing, each with its lines of the legend.
class ModelPicture {
 public:
  explicit ModelPicture(const Simulation& simulation)
      : simulation_(simulation), equilibrium_(simulation.equilibrium()), body_(simulation.body()) {
    drawing_.title = simulation.deck().title.empty() ? "The model" : simulation.deck().title;
  }

  std::string text() {
    add_blocks();
    add_interfaces();
    add_supports();
    if (simulation_.deck().has_path()) add_stages();
    add_motion(whole_);
    add_gauges(whole_);
    drawing_.caption =
        fmt::format("{} blocks, {} unknowns", equilibrium_.num_blocks(), equilibrium_.num_unknowns());
    return svg::to_svg(drawing_);
  }

 private:
  void add_key(KeyEntry::Kind kind, int colour, std::string name) {
    drawing_.key.push_back({kind, colour, std::move(name)});
  }

  void add_blocks() {
    const MaterialColours colours = material_colours(body_.assembly);
    for (const Block& block : body_.assembly.blocks)
      drawing_.polygons.push_back({.outline = block.outline.vertices, .tint = colours.of(block)});
    add_to_key(colours, drawing_);
  }

  /// Those that can crack, slide or open; bonds are lines between blocks like others.
  void add_interfaces() {
    std::map<int, int> colours;
    for (const InterfacePoint& point : equilibrium_.interfaces().points) {
      if (!point.is_active() || point.interface < 0) continue;
      const auto [at, is_new] = colours.try_emplace(point.interface, static_cast<int>(colours.size()));
      if (is_new)
        add_key(KeyEntry::Kind::line, at->second,
                equilibrium_.interfaces().names[static_cast<std::size_t>(point.interface)]);
      const Vec2 along = point.weight / body_.thickness * Vec2(-point.normal.y(), point.normal.x());
      const double reach =
          is_at_end(point) ? 1 : 0.5;  // what a point at a corner stands for lies to one side of it
      drawing_.strokes.push_back({.start = on_side(point, point.x - reach * along),
                                  .end = on_side(point, point.x + reach * along),
                                  .colour = at->second});
    }
  }

  bool is_at_end(const InterfacePoint& point) const {
    if (point.cut) return false;
    const Side& side = body_.assembly.sides[point.side];
    constexpr double near = 1e-6;
    const double length = (side.end - side.start).norm();
    return std::min((point.x - side.start).norm(), (point.x - side.end).norm()) < near * length;
  }
  /// The nearest place on the side of a point.
  Vec2 on_side(const InterfacePoint& point, const Vec2& x) const {
    if (point.cut) return x;
    const Side& side = body_.assembly.sides[point.side];
    const Vec2 along = side.end - side.start;
    return side.start + std::clamp((x - side.start).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
  }

  void add_symbols(const Functional& of, svg::Symbol symbol) {
    for (const auto& [node, row] : of.rows) {
      if (node.value() >= equilibrium_.num_blocks()) continue;  // a jump moves with its block
      const ActingForce acting = acts_at(row);
      symbol.at = body_.block(node).moments.centroid + acting.offset;
      symbol.along = acting.force;
      drawing_.symbols.push_back(symbol);
    }
  }

  /// From and until which stage each spring of a support is there: ", from 'a'", ", until 'b'", or nothing.
  std::vector<std::string> whens_of_supports() const {
    std::vector<std::string> out(equilibrium_.all_supports().size());
    const std::vector<StageParameters> stages = simulation_.deck().loaded_stages();
    for (const auto& [spring, stage] : equilibrium_.added_springs())
      out[spring] += fmt::format(", from '{}'", stages[stage].name);
    for (const auto& [spring, stage] : equilibrium_.removed_springs())
      out[spring] += fmt::format(", until '{}'", stages[stage].name);
    return out;
  }

  void add_supports() {
    const std::vector<std::string> whens = whens_of_supports();
    for (std::size_t i = 0; i < whens.size(); ++i)
      if (const Spring& spring = equilibrium_.all_supports()[i]; !spring.reaction.empty())
        add_symbols(spring.displacement,
                    {.mark = Mark::held, .colour = svg::black, .name = spring.reaction + whens[i]});
    for (const Spring& spring : equilibrium_.driven_springs())
      add_symbols(spring.displacement,
                  {.mark = Mark::held, .colour = svg::vermilion, .name = spring.reaction});
    if (!equilibrium_.all_supports().empty()) add_key(KeyEntry::Kind::held, svg::black, "held");
    add_plates();
    if (!equilibrium_.driven_springs().empty())
      add_key(KeyEntry::Kind::held, svg::vermilion, "displacement prescribed");
  }

  void add_plates() {
    const auto before = drawing_.strokes.size();
    for (const auto& [name, support] : simulation_.deck().supports)
      if (support.fix == Fix::straight)
        drawing_.strokes.push_back({.start = locate(body_.assembly, support.over->front()),
                                    .end = locate(body_.assembly, support.over->back()),
                                    .colour = svg::black});
    if (drawing_.strokes.size() > before) add_key(KeyEntry::Kind::line, svg::black, "kept straight");
  }

  /// The forces of each stage in a colour of its own.
  void add_stages() {
    const auto& stages = equilibrium_.stages();
    for (std::size_t s = 0; s + 1 < stages.size(); ++s)
      add_stage(stages[s], static_cast<int>(s) + 2, ", in full first");
    add_stage(stages.back(), svg::vermilion, ", × load factor");
    const auto& later = equilibrium_.later_stages();
    for (std::size_t s = 0; s < later.size(); ++s)
      add_stage(later[s], static_cast<int>(stages.size() + s) + 1, ", then × load factor");
  }

  void add_stage(const Loading& stage, int colour, const std::string& how) {
    Functional acting = forces_of(stage);
    const std::size_t as_a_whole = gather_body_forces(acting, colour);
    add_symbols(acting, {.mark = Mark::force, .colour = colour});
    const std::size_t strained = num_strained(stage);
    if (acting.rows.empty() && as_a_whole == 0 && strained == 0) return;
    std::string name = stage.name + how;
    if (strained > 0) name += fmt::format(" (initial strain or stress in {} blocks)", strained);
    if (as_a_whole > 0) name += fmt::format(" (at the middle: on {} blocks as a whole)", as_a_whole);
    add_key(KeyEntry::Kind::force, colour, std::move(name));
  }

  /// Blocks with initial stress, be it its slopes alone.
  std::size_t num_strained(const Loading& stage) const {
    if (stage.reference_stress.empty()) return 0;
    std::size_t out = 0;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
      const Block& block = body_.block(BlockId(b));
      const auto parts = eigenstress_at(body_, BlockId(b), block.moments.centroid);
      out += std::ranges::any_of(
          parts, [&](const StressShare& part) { return !stage.reference_stress[part.place].isZero(0); });
    }
    return out;
  }

  /// What pushes and pulls in a stage, without what initial stress does in blocks and joints: no arrow tells that.
  Functional forces_of(const Loading& stage) const {
    constexpr double rounding = 1e-9;
    std::vector<double> force = stage.reference_work;
    if (!stage.reference_stress.empty()) {
      const StressOffset offset = stress_offset(body_, equilibrium_.interfaces(), stage.reference_stress);
      for (std::size_t i = 0; i < offset.force.size(); ++i) force[i] -= offset.force[i];
    }
    Functional before, out;
    before.add_rows(1, stage.reference_work);
    out.add_rows(1, force);
    double largest = 0;
    for (const auto& part : before.rows) largest = std::max(largest, part.second.head<2>().norm());
    std::erase_if(out.rows, [&](const auto& part) {
      return !(part.second.template head<2>().norm() > rounding * largest);
    });
    return out;
  }

  /// Takes out what acts on blocks at their centroids, as weight does; of more than one it becomes one force at their
  /// middle. How many these are.
  std::size_t gather_body_forces(Functional& acting, int colour) {
    const auto is_body_force = [&](const std::pair<BlockId, Vec6>& part) {
      constexpr double rounding = 1e-9;
      if (part.first.value() >= equilibrium_.num_blocks()) return false;
      const ActingForce at = acts_at(part.second);
      return !at.force.isZero(0) &&
             at.offset.norm() < rounding * equilibrium_.block_size()[part.first.value()];
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(acting.rows, is_body_force));
    if (count < 2) return 0;
    svg::Symbol all{.mark = Mark::force, .at = Vec2::Zero(), .along = Vec2::Zero(), .colour = colour};
    Middle middle;
    for (const auto& part : acting.rows) {
      if (!is_body_force(part)) continue;
      all.along += part.second.head<2>();
      middle.include(body_.block(part.first));
    }
    all.at = middle.place();
    if (is_downward(all.along)) all.name = "g";
    drawing_.symbols.push_back(all);
    std::erase_if(acting.rows, is_body_force);
    return count;
  }

  static bool is_downward(const Vec2& force) {
    constexpr double straight = 1e-6;
    return force.y() < 0 && std::abs(force.x()) < straight * -force.y();
  }

  const Simulation& simulation_;
  const Equilibrium& equilibrium_;
  const Body& body_;
  svg::Drawing drawing_;
  const ModelDrawing whole_{drawing_, simulation_};
};

}  // namespace

ActingForce acts_at(const Vec6& row) {
  ActingForce out;
  const Vec2 force = row.head<2>();
  const double square = force.squaredNorm(), of_shear = row[5], half_moment = row[2] / 2;
  constexpr double rounding = 1e-12;
  if (!(force.norm() > rounding * row.norm())) return out;
  out.force = force;
  out.offset = Vec2(force.x() * row[3] + force.y() * (of_shear + half_moment),
                    force.x() * (of_shear - half_moment) + force.y() * row[4]) /
               square;
  return out;
}

std::string model_picture(const Simulation& simulation) { return ModelPicture(simulation).text(); }

void write_model_picture(const RunFolder& folder, const Simulation& simulation) {
  if (simulation.equilibrium().num_blocks() > most_drawn_blocks) return;
  write_whole(folder.file("model.svg"), model_picture(simulation), Flush::to_system);
}

}  // namespace dda
