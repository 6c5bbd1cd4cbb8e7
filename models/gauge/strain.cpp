#include <algorithm>

#include "models/body/motion.hpp"
#include "models/body/place_schema.hpp"
#include "models/gauge/gauge.hpp"
#include "models/load/eigenstress.hpp"

namespace dda {
namespace {

enum class Component { xx, yy, xy, zz };

struct MeanParameters : Place {
  std::vector<std::string> regions;
  Component component = Component::xx;
  Position where;
};

/// A block and its share in a mean.
struct Share {
  BlockId block;
  double weight;
};

/// Blocks that meet at a point in equal shares, or those of some regions by their areas.
std::vector<Share> shares(const Body& body, const MeanParameters& p) {
  std::vector<Share> out;
  if (p.at) {
    const auto blocks = blocks_of(body.assembly, p, p.where);
    for (const BlockId id : blocks) out.push_back({id, 1 / static_cast<double>(blocks.size())});
    return out;
  }
  const Chosen chosen{p.regions, {}};
  chosen.require_known(body, p.where);
  double area = 0;
  for (std::size_t i = 0; i < body.assembly.num_blocks(); ++i)
    if (const BlockId id{i}; chosen.has(body, id)) {
      out.push_back({id, body.block(id).moments.area});
      area += out.back().weight;
    }
  for (Share& share : out) share.weight /= area;
  return out;
}

/// Of a component in the plane.
Vec3 unit(Component component) { return Vec3::Unit(static_cast<int>(component)); }

Vec6 row_of(const Vec3& of_strain) {
  Vec6 out = Vec6::Zero();
  out.tail<3>() = of_strain;
  return out;
}

/// Rows of e·ε: the mean strain of a block, and at the point `at` what the gradient of its strain adds.
Functional rows_of(const Body& body, const MeanParameters& p, const Share& share, const Vec3& e) {
  const auto& [block, weight] = share;
  Functional out{{{block, row_of(weight * e)}}};
  if (const auto node = body.gradient_of(block); node && p.at)
    out.rows.emplace_back(
        *node, weight * gradient_strain(body, block, locate(body.assembly, *p.at)).transpose() * e);
  return out;
}

/// σ0, or what is out of the plane: its mean in a block, and at the point `at` what its slopes add.
std::vector<StressShare> eigenstress_of(const Body& body, const MeanParameters& p, BlockId block) {
  if (!p.at) return {{block.value(), 1}};
  return eigenstress_at(body, block, locate(body.assembly, *p.at));
}

/// Mean of what comes about out of the plane in some blocks: σz in plane strain, εz in plane stress. Refuses the other
/// one, which is nothing.
Functional out_of_plane(const GaugeSources& sources, const MeanParameters& p, Plane where) {
  Functional out;
  const auto part = [](std::span<const double> of, std::size_t place) { return of.empty() ? 0 : of[place]; };
  for (const Share& share : shares(sources.body, p)) {
    const auto& [block, weight] = share;
    const Material& material = sources.body.material(block);
    if (material.plane() != where)
      throw InputError(
          p.where,
          where == Plane::strain
              ? "`zz` of a stress is 0 in plane stress; take that of the strain, or `plane: strain`"
              : "`zz` of a strain is 0 in plane strain; take that of the stress, or `plane: stress`");
    out.add(1, rows_of(sources.body, p, share, material.out_of_plane()));
    for (const auto& [place, part_of_it] : eigenstress_of(sources.body, p, block)) {
      out.constant += weight * part_of_it * part(sources.dead_out_of_plane, place);
      out.per_load_factor += weight * part_of_it * part(sources.reference_out_of_plane, place);
    }
  }
  return out;
}

/// Mean strain (εx, εy, γxy) of some blocks, e·ε, or εz.
class StrainGauge final : public Gauge {
 public:
  explicit StrainGauge(MeanParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    if (p_.component == Component::zz) return out_of_plane(sources, p_, Plane::stress);
    Functional out;
    for (const Share& share : shares(sources.body, p_))
      out.add(1, rows_of(sources.body, p_, share, unit(p_.component)));
    return out;
  }
  Dimension dimension() const override { return dimension::none; }

 private:
  MeanParameters p_;
};

/// Mean stress of some blocks, e·σ with σ = C ε + σ0(λ), or σz.
class StressGauge final : public Gauge {
 public:
  explicit StressGauge(MeanParameters p) : p_(std::move(p)) {}
  Functional functional(const GaugeSources& sources) const override {
    if (p_.component == Component::zz) return out_of_plane(sources, p_, Plane::strain);
    Functional out;
    const Vec3 e = unit(p_.component);
    const auto part = [&](std::span<const Vec3> stress, std::size_t place) {
      return stress.empty() ? 0 : e.dot(stress[place]);
    };
    for (const Share& share : shares(sources.body, p_)) {
      const auto& [block, weight] = share;
      out.add(1, rows_of(sources.body, p_, share, sources.body.material(block).stiffness() * e));
      for (const auto& [place, part_of_it] : eigenstress_of(sources.body, p_, block)) {
        out.constant += weight * part_of_it * part(sources.dead_stress, place);
        out.per_load_factor += weight * part_of_it * part(sources.reference_stress, place);
      }
    }
    return out;
  }
  Dimension dimension() const override { return dimension::stress; }

 private:
  MeanParameters p_;
};

Schema<MeanParameters> schema(const std::string& what) {
  using P = MeanParameters;
  return Schema<P>(what)
      .spot("at", &P::at,
            {.text = "The point, or the name of one in `scene.points`, in the block that is meant; or give "
                     "`regions`."})
      .spot("inside", &P::inside,
            {.text =
                 "A point inside the block that is meant where several blocks meet at `at`; otherwise it is "
                 "their mean."})
      .texts("regions", &P::regions,
             {.fallback = std::vector<std::string>{}, .text = "Regions whose mean over the area is meant."})
      .one_of(
          "component", &P::component,
          {{"xx", Component::xx}, {"yy", Component::yy}, {"xy", Component::xy}, {"zz", Component::zz}},
          {.text = "Which component; `xy` of a strain is γxy, twice the tensor's; `zz`, out of the plane, is "
                   "the stress in plane strain and the strain in plane stress."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.at.has_value() == !p.regions.empty())
          findings.add(where, "give either `at`, a point, or `regions`, the mean of which is meant");
      });
}

Schema<MeanParameters> strain_schema() {
  return schema(
      "Strain of the block at a point, or the mean of regions, initial strain included. In a motion that of "
      "the "
      "deformation with its turn, F − I.");
}

Schema<MeanParameters> stress_schema() {
  return schema(
      "Stress of the block at a point, or the mean of regions, initial stress included, tension positive. In "
      "a "
      "motion it is meant for small turns.");
}

}  // namespace

DDA_REGISTER(gauges(), "strain", strain_schema(), make_of<StrainGauge>);
DDA_REGISTER(gauges(), "stress", stress_schema(), make_of<StressGauge>);

}  // namespace dda
