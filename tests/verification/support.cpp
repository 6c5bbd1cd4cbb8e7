#include "verification/support.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <stdexcept>

#include "continuation/linear/direct/direct_solver.hpp"
#include "studies/dda/case/simulation.hpp"

namespace dda::verification {
namespace {

std::vector<std::shared_ptr<const Material>> materials_of(const Assembly& assembly, const Deck& deck) {
  std::vector<std::shared_ptr<const Material>> out;
  for (const Region& region : assembly.regions)
    out.push_back(deck.material_names.at(region.material).make(deck.plane));
  return out;
}

Traced traced(const Simulation& simulation, const Point& point) {
  const Candidate& here = simulation.walker().here();
  Traced out{.control = to_string(point.kind),
             .state = here.state,
             .load = here.load,
             .dissipated = here.dissipated,
             .stored = here.stored,
             .work = here.work,
             .gauges = {},
             .negative = point.num_negative.value_or(-1),
             .negative_under_control = point.num_negative_under_control.value_or(-1),
             .switched = point.switched};
  for (const NamedGauge& gauge : simulation.gauges().gauges)
    out.gauges[gauge.name] = simulation.walker().value(gauge.functional);
  return out;
}

}  // namespace

Structure::Structure(const std::string& deck_text)
    : deck(deck_from_text(deck_text, "verification.yaml", {}).deck),
      assembly(mesh(deck.scene)),
      body{assembly, deck.thickness, materials_of(assembly, deck), nullptr,
           second_order_blocks(assembly, deck.kinematics)},
      equilibrium(body, deck) {}

std::size_t Trace::peak() const {
  const auto highest = std::ranges::max_element(points, {}, &Traced::load);
  return static_cast<std::size_t>(highest - points.begin());
}

Trace follow(const std::string& deck_text) {
  const DeckFile file = deck_from_text(deck_text, "verification.yaml", {});
  Timings timings;
  Simulation simulation(file.deck, timings);
  simulation.prepare();
  if (const std::string why = simulation.apply_dead_loads(); !why.empty()) throw std::runtime_error(why);
  simulation.walker().effort().count_steps_anew();
  simulation.begin_path();
  Trace out;
  for (const Point& point : simulation.path()) out.points.push_back(traced(simulation, point));
  out.ending = simulation.path().ending();
  return out;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  const auto n = static_cast<Eigen::Index>(block_unknowns * matrix.num_rows());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t row = 0; row < matrix.num_rows(); ++row)
    for (std::size_t slot = matrix.row_start()[row]; slot < matrix.row_start()[row + 1]; ++slot)
      out.block<6, 6>(static_cast<Eigen::Index>(6 * row),
                      static_cast<Eigen::Index>(6 * matrix.columns()[slot])) = matrix.value(slot);
  return out;
}

std::vector<double> solve(const BlockMatrix& matrix, std::vector<double> force) {
  const auto solver = direct_solvers().choose("cholmod").make();
  if (!solver->factor(matrix)) throw std::runtime_error("the intact stiffness is singular");
  solver->solve(force, 1);
  return force;
}

std::vector<double> intact_response(const Equilibrium& equilibrium) {
  const Loading& loading = equilibrium.stages().back();
  std::vector<double> force = loading.reference;
  for (std::size_t i = 0; i < loading.dead.size(); ++i) force[i] += loading.dead[i];
  return solve(equilibrium.intact(), std::move(force));
}

double smallest_scaled_eigenvalue(const BlockMatrix& matrix) {
  const Eigen::MatrixXd k = dense(matrix);
  // A diagonal entry that is not positive is itself a proof.
  if (k.diagonal().minCoeff() <= 0) return k.diagonal().minCoeff();
  const Eigen::VectorXd scale = k.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * k * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

std::string pressed_blocks(const std::string& treatment, const std::string& law, const std::string& stages,
                           const std::string& path) {
  return fmt::format(R"(
scene:
  regions:
    - {{name: lower, material: stone, vertices: [[0, 0], [40, 0], [40, 10], [0, 10]]}}
    - {{name: upper, material: stone, vertices: [[0, 10], [40, 10], [40, 20], [0, 20]]}}
  curves: {{joint: [[0, 10], [40, 10]]}}
  boundaries: {{foot: [[0, 0], [40, 0]], head: [[0, 20], [40, 20]]}}
thickness: 2
materials: {{stone: {{type: linear_elastic, young_modulus: 1000, poisson_ratio: 0}}}}
interfaces:
  joint: {{points: midpoint, treatment: {}, law: {}}}
supports:
  foot: {{boundary: foot, fix: xy}}
  guide: {{at: [20, 15], fix: rotation}}
stages:
  - {{loads: [{{type: edge_traction, boundary: head, traction: [0, -3]}}]}}
{}gauges:
  slip: {{type: relative_displacement, from: [20, 10], from_inside: [20, 9], to: [20, 10], to_inside: [20, 11], direction: [1, 0]}}
  pushed: {{type: displacement, at: [20, 15], direction: [1, 0]}}
path: {}
)",
                     treatment, law, stages, path);
}

Vec3 strain_of(const std::vector<double>& d, std::size_t block) {
  return Eigen::Map<const Vec3>(d.data() + 6 * block + 3);
}

}  // namespace dda::verification
