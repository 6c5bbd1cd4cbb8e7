// Times of the single operations that a path is made of, on a beam of Voronoi blocks in which every interface
// can crack: `bin/micro_benchmarks`, with Google Benchmark's own arguments. The argument is the number of
// blocks.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "continuation/state/system.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

constexpr auto update = LinearSystem::Update::low_rank;

std::string beam_deck(long blocks) {
  return fmt::format(R"(
scene:
  regions: [{{name: beam, material: concrete, vertices: [[0, 0], [400, 0], [400, 100], [0, 100]]}}]
  subdivision: {{type: voronoi, blocks: {}, seed: 1}}
thickness: 100
materials: {{concrete: {{type: linear_elastic, young_modulus: 27500, poisson_ratio: 0.2}}}}
interfaces:
  joints:
    between: [concrete, concrete]
    law: {{type: linear_softening, tensile_strength: 2.9, fracture_energy: 0.1}}
supports:
  left: {{at: [50, 0], fix: xy}}
  right: {{at: [350, 0], fix: y}}
stages:
  - loads:
      - {{type: point_load, at: [150, 100], force: [0, -0.5]}}
      - {{type: point_load, at: [250, 100], force: [0, -0.5]}}
)",
                     blocks);
}

/// A beam loaded as if it were elastic, so far that its joints are partly intact, partly softening.
class Beam {
 public:
  static constexpr double load_factor = 15000;  ///< [N], near the peak load of the cracking beam

  explicit Beam(long blocks)
      : structure_(beam_deck(blocks)),
        equilibrium_(structure_.equilibrium()),
        system_(equilibrium_, direct_solvers().choose("cholmod"), update) {
    system_.set_stage(equilibrium_.stages().size() - 1);
    displacement_.resize(equilibrium_.num_unknowns());
    system_.linear().solve_base(system_.loading().reference, displacement_);
    for (double& value : displacement_) value *= load_factor;
  }

  const Structure& structure() const { return structure_; }
  const Equilibrium& equilibrium() const { return equilibrium_; }
  System& system() { return system_; }
  const std::vector<double>& displacement() const { return displacement_; }
  LawValues laws() const { return system_.laws(displacement_, load_factor); }
  /// Interface points that are asked at run time.
  std::size_t num_points() const { return laws().opening.size(); }

 private:
  Structure structure_;
  Equilibrium equilibrium_;
  System system_;
  std::vector<double> displacement_;
};

/// The beams that were asked for, by size; to be emptied before MPI ends, which MUMPS may have started.
std::map<long, std::unique_ptr<Beam>>& beams() {
  static std::map<long, std::unique_ptr<Beam>> made;
  return made;
}

/// The beam of a benchmark, meshed once per size; its counts become columns of the output.
Beam& beam_of(benchmark::State& state) {
  std::unique_ptr<Beam>& beam = beams()[state.range(0)];
  if (!beam) beam = std::make_unique<Beam>(state.range(0));
  state.counters["blocks"] = static_cast<double>(beam->equilibrium().num_blocks());
  state.counters["points"] = static_cast<double>(beam->num_points());
  return *beam;
}

void gathering(benchmark::State& state) {
  const Beam& beam = beam_of(state);
  std::vector<double> q(2 * beam.num_points());
  for (auto _ : state) {
    beam.equilibrium().gather(beam.displacement(), q);
    benchmark::DoNotOptimize(q.data());
  }
}

/// With the gathering of their openings.
void laws(benchmark::State& state) {
  const Beam& beam = beam_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(beam.laws().traction.data());
}

void scattering(benchmark::State& state) {
  const Beam& beam = beam_of(state);
  std::vector<double> t;
  for (const Vec2& traction : beam.laws().traction) t.insert(t.end(), {traction.x(), traction.y()});
  std::vector<double> f(beam.equilibrium().num_unknowns());
  for (auto _ : state) {
    std::ranges::fill(f, 0.0);
    beam.equilibrium().scatter_add(t, f);
    benchmark::DoNotOptimize(f.data());
  }
}

/// The equilibrium from the blocks: interface points, intact stiffness, loads.
void assembly(benchmark::State& state) {
  const Beam& beam = beam_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(beam.structure().equilibrium().num_unknowns());
}

/// Analysis and numbers of the intact stiffness.
void factorisation(benchmark::State& state) {
  const Beam& beam = beam_of(state);
  const DirectSolverChoice solver = direct_solvers().choose("cholmod");
  for (auto _ : state)
    benchmark::DoNotOptimize(LinearSystem(beam.equilibrium(), solver, update).num_factorisations());
}

/// Of a right-hand side whose solution is not kept, as that of the loads is.
void solve(benchmark::State& state) {
  Beam& beam = beam_of(state);
  const std::vector<double> b = Random(1).vector(beam.equilibrium().num_unknowns(), 1);
  std::vector<double> y(b.size());
  for (auto _ : state) {
    beam.system().linear().solve_base(b, y);
    benchmark::DoNotOptimize(y.data());
  }
}

void sizes(benchmark::internal::Benchmark* of) {
  for (const long blocks : {500, 2000, 8000}) of->Arg(blocks);
  of->Unit(benchmark::kMicrosecond);
}

BENCHMARK(gathering)->Apply(sizes);
BENCHMARK(laws)->Apply(sizes);
BENCHMARK(scattering)->Apply(sizes);
BENCHMARK(assembly)->Apply(sizes);
BENCHMARK(factorisation)->Apply(sizes);
BENCHMARK(solve)->Apply(sizes);

}  // namespace
}  // namespace dda

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  dda::beams().clear();
  benchmark::Shutdown();
  return 0;
}
