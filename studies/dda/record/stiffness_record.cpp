#include "studies/dda/record/stiffness_record.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "models/equilibrium/stiffness_parts.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
using Json = nlohmann::ordered_json;

Json rows(const Matrix& k) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < k.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < k.cols(); ++j) row.push_back(k(i, j));
    out.push_back(std::move(row));
  }
  return out;
}

/// "3" of a block, "gradient of 3" of its strain gradient, "jump 1" of a node behind these.
std::string name_of(Eigen::Index index, const Equilibrium& equilibrium) {
  const auto node = static_cast<std::size_t>(index);
  if (node < equilibrium.num_blocks()) return std::to_string(node + 1);
  if (node >= equilibrium.num_block_nodes())
    return fmt::format("jump {}", node - equilibrium.num_block_nodes() + 1);
  return fmt::format("gradient of {}",
                     equilibrium.gradients()[node - equilibrium.num_blocks()].block.value() + 1);
}

/// The blocks of the upper half that are not zero.
std::string text(const std::string& name, const Matrix& k, const Equilibrium& equilibrium) {
  std::string out;
  for (Eigen::Index i = 0; i < k.rows(); i += 6)
    for (Eigen::Index j = i; j < k.cols(); j += 6) {
      const Mat6 block = k.block<6, 6>(i, j);
      if (block.isZero(0)) continue;
      out += fmt::format("  {}, blocks {} and {}\n", name, name_of(i / 6, equilibrium),
                         name_of(j / 6, equilibrium));
      constexpr double round_off = 1e-13;
      const double unit = round_off * k.cwiseAbs().maxCoeff();
      for (const auto& row : block.rowwise()) {
        for (const double value : row)
          out += std::abs(value) > unit ? fmt::format("{:>13.4e}", value) : fmt::format("{:>13}", 0);
        out += '\n';
      }
    }
  return out;
}

std::string eigenvalues(const Matrix& k) {
  const Eigen::SelfAdjointEigenSolver<Matrix> own(k, Eigen::EigenvaluesOnly);
  std::string out;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(6, k.rows()); ++i)
    out += fmt::format("{:>14.5e}", own.eigenvalues()[i]);
  return out;
}

void add(StiffnessRecord& out, const std::string& which, const StiffnessParts& parts,
         const Equilibrium& equilibrium) {
  const std::pair<const char*, const Matrix*> named[] = {{"strain", &parts.strain},
                                                         {"contact", &parts.contact},
                                                         {"support", &parts.support},
                                                         {"weak", &parts.weak}};
  const char* symbols[] = {"K⁰ (strain)", "Kᶜ (contact)", "Kˢ (support)", "Kʷ (weak springs)"};
  out.text += which + ": lowest eigenvalues of K⁰ + Kᶜ + Kˢ + Kʷ\n" + eigenvalues(parts.sum()) + '\n';
  for (std::size_t i = 0; i < std::size(named); ++i) {
    out.numbers[which][named[i].first] = rows(*named[i].second);
    out.text += text(symbols[i], *named[i].second, equilibrium);
  }
}

/// Gives back to the contacts what consistent joints subtract at points of which nothing is left.
void drop_released(StiffnessParts& parts, const Equilibrium& equilibrium, const LawValues& laws) {
  std::vector<std::pair<BlockId, BlockId>> pairs;
  for (std::size_t p = 0; p < laws.tangent.size(); ++p)
    equilibrium.point(p).for_each_stress([&](BlockId a, const Mat26&) {
      equilibrium.point(p).for_each_stress([&](BlockId b, const Mat26&) { pairs.emplace_back(a, b); });
    });
  BlockMatrix back(equilibrium.num_leading(), pairs);
  for (std::size_t p = 0; p < laws.tangent.size(); ++p)
    if (laws.is_released(p)) add_stress_energy(back, equilibrium.point(p));
  for (std::size_t row = 0; row < back.num_rows(); ++row)
    for (std::size_t slot = back.row_start()[row]; slot < back.row_start()[row + 1]; ++slot)
      parts.contact.block<6, 6>(static_cast<Eigen::Index>(6 * row),
                                static_cast<Eigen::Index>(6 * back.columns()[slot])) += back.value(slot);
}

}  // namespace

StiffnessRecord stiffness_record(const Simulation& simulation) {
  const System& system = simulation.system();
  const State& here = simulation.walker().state();
  const LawValues laws = system.laws(here);
  StiffnessRecord out{.numbers = Json::object(), .text = {}};
  const Equilibrium& equilibrium = simulation.equilibrium();
  add(out, "algorithmic", stiffness_parts(equilibrium, system.all_tangents(laws, false)), equilibrium);
  StiffnessParts physical = stiffness_parts(equilibrium, system.all_tangents(laws, true));
  drop_released(physical, equilibrium, laws);
  add(out, "physical", physical, equilibrium);
  return out;
}

}  // namespace dda
