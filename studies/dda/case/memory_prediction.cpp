#include "studies/dda/case/memory_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "continuation/solve/eigenmodes.hpp"
#include "framework/base/threads.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/case/crack_estimate.hpp"

namespace dda {
namespace {

constexpr double number = sizeof(double), mib = 1024.0 * 1024.0;

/// Pages of libraries that a process holds once it has used them [MiB]. Measured as the sum of Rss over the
/// files in /proc/PID/smaps, of a beam's run that uses one against the same run without it.
namespace library {
constexpr double of_every_run = 21;  // HDF5, LOCA and NOX, the program's own pages
constexpr double tpetra = 8, anasazi = 7, amesos2 = 17, mumps = 6;
}  // namespace library

/// Whether a damaged point bears friction.
bool has_friction(const InterfacePoint& point) {
  if (!point.law->can_crack()) return false;
  const double opening = point.law->initial_kappa(point.stiffness);
  History damaged;
  damaged.kappa = 2 * opening;
  constexpr double far = 1e6;
  return !point.law->slip_gradient({-opening, far * opening}, damaged, point.stiffness).isZero(0);
}

/// What a run with this deck uses and how large it is.
struct Case {
  explicit Case(const Simulation& of)
      : simulation(of), equilibrium(of.equilibrium()), path(of.deck().path), solver(path.linear.make()) {
    const auto control = path.control.make(of.gauges());
    if (const LoadSolver* increments = control->load_solver()) {
      has_increments = true;
      has_columns = has_newton_at_loads = increments->needs_tangents();
    }
    solver_bytes = solver->factor_bytes(equilibrium.intact());
    most_columns = static_cast<double>(most_columns_beside(solver->factor_flops()));
    for (const InterfacePoint& point : equilibrium.interfaces().points) {
      iterates = iterates || point.multiplier == Multiplier::iterated;
      releases = releases || point.law->releases_at_once();
      slides = slides || has_friction(point);
    }
  }

  double n() const { return static_cast<double>(equilibrium.num_unknowns()); }
  double stored() const { return static_cast<double>(equilibrium.intact().num_stored()); }
  double crackable() const { return static_cast<double>(equilibrium.interfaces().num_crackable()); }
  bool has_multipliers() const { return equilibrium.num_unknown_multipliers() > 0; }
  bool has_halves() const { return path.linear.name() == "cholmod" && !has_multipliers(); }
  bool refactorises() const { return path.update == LinearSystem::Update::refactorise; }
  /// Modes of more unknowns than are worth a dense problem are Anasazi's.
  bool has_modes() const { return simulation.deck().record.eigenvalues.count > 0 && !is_small(); }
  bool switches() const { return path.branch == Branching::to_lowest && !is_small(); }
  bool is_small() const { return equilibrium.num_unknowns() <= dense_below; }

  const Simulation& simulation;
  const Equilibrium& equilibrium;
  const PathParameters& path;
  const std::unique_ptr<DirectSolver> solver;
  double solver_bytes = 0;  ///< of a factorisation by it
  double most_columns = 0;
  bool iterates = false, releases = false, slides = false;
  bool has_increments = false;       ///< of the load, which end before much has cracked
  bool has_newton_at_loads = false;  ///< of them: tangents beyond the strength, indefinite
  bool has_columns = true;
};

constexpr double bytes_per_block = 36 * number;

/// One more copy of the matrix.
double matrix_bytes(const Case& of) { return bytes_per_block * of.stored(); }

/// MUMPS' factor of a tangent that is not definite, and unsymmetric where points slide.
double indefinite_bytes(const Case& of, bool slides) {
  if (of.path.linear.name() != "cholmod") return of.solver_bytes;
  MumpsMatrix matrix(slides ? MumpsMatrix::Symmetry::none : MumpsMatrix::Symmetry::general);
  return matrix.factor_bytes(of.equilibrium.intact());
}

/// Couplings G of so many columns, and those before they last grew.
double couplings_bytes(double columns) { return 1.25 * number * columns * columns; }

/// Y: a half solution is as long as the separators on its way, some 10 √n; each thread has room for one group
/// of 8.
double half_column_bytes(const Case& of, double columns) {
  return number * (10 * columns * std::sqrt(of.n()) + 8 * num_threads() * of.n());
}

/// Z.
double whole_column_bytes(const Case& of, double columns) {
  return number * std::min(columns * of.n(), static_cast<double>(most_kept_numbers));
}

double column_bytes(const Case& of, double columns) {
  return couplings_bytes(columns) +
         (of.has_halves() ? half_column_bytes(of, columns) : whole_column_bytes(of, columns));
}

/// Of states, directions and right-hand sides that live at a time, counted: 88 in a step on all unknowns, else
/// some 32; and by point 6 histories, 4 evaluations of its law and 4 tangents.
double vector_bytes(const Case& of, bool is_whole) {
  constexpr double of_whole = 88, without = 32;
  constexpr double of_point = 6 * sizeof(History) + 16 * number * 4;
  return number * of.n() * (is_whole ? of_whole : without) +
         of_point * static_cast<double>(of.equilibrium.num_active());
}

/// Points on a line through the structure have at most so many.
double most_on_a_line(const Case& of) {
  return 4 * std::sqrt(static_cast<double>(of.equilibrium.num_points()));
}

/// Whatever the course: steps are taken on all unknowns where the cracked points alone do not tell, also where
/// they have redundant multipliers.
bool always_whole(const Case& of) {
  return of.releases || of.iterates || of.refactorises() || of.switches() ||
         (of.has_multipliers() && of.crackable() > most_on_a_line(of));
}

/// Whether its first matrices may be indefinite already.
bool is_indefinite(const Case& of) { return of.has_multipliers() || of.switches() || of.has_newton_at_loads; }

double library_bytes(const Case& of, bool whole, bool mumps) {
  const std::pair<bool, double> all[] = {
      {whole, library::tpetra},
      {!whole && of.has_modes(), library::anasazi},
      {of.path.linear.name() == "amesos2", library::amesos2},
      {mumps || of.path.linear.name() == "mumps" || of.simulation.deck().record.condition, library::mumps}};
  double sum = 0;
  for (const auto& [is_used, size] : all) sum += is_used ? size : 0;
  return mib * (library::of_every_run + sum);
}

/// Beside the path's own matrices: those of modes and of the condition, one after the other.
double other_matrix_bytes(const Case& of) {
  const EigenvalueParameters& modes = of.simulation.deck().record.eigenvalues;
  const double blocks = std::max(8, (2 * modes.count + 2) / 3 + 2) + 1;
  double out = 0;
  if (of.has_modes() || of.switches())
    out = of.solver_bytes + 2 * matrix_bytes(of) + 6 * blocks * number * of.n();
  if (of.simulation.deck().record.condition)
    out = std::max(out, indefinite_bytes(of, of.releases) + 2 * matrix_bytes(of));
  return out;
}

/// Redundant multipliers are counted with a matrix of their own, before there are columns.
double redundancy_bytes(const Case& of) {
  return of.has_multipliers() ? of.solver_bytes + 2 * matrix_bytes(of) : 0;
}

/// One base and the columns of the points that crack.
MemoryPrediction updates_alone(const Case& of, double cracked) {
  const double systems = of.iterates ? 2 : 1;
  MemoryPrediction out;
  out.cracked_points = static_cast<std::size_t>(cracked);
  out.libraries = library_bytes(of, always_whole(of), is_indefinite(of));
  out.factor = systems * of.solver_bytes + other_matrix_bytes(of);
  out.vectors = std::max(matrix_bytes(of), vector_bytes(of, always_whole(of)));
  out.columns = std::max(systems * column_bytes(of, 2 * cracked), redundancy_bytes(of));
  return out;
}

/// Of new bases, which keep whole columns.
struct Rounds {
  double columns;  ///< as multiples of how many may be made at once
  bool slides;     ///< a base takes the friction of points that slide
  double active;   ///< share of columns that an iteration uses: three dense matrices of that size
};

/// A base after the other: first that of the intact structure with all columns that are worth it, then
/// indefinite ones.
MemoryPrediction new_bases(const Case& of, const Rounds& rounds) {
  const double all = of.refactorises() ? 0 : std::min(of.most_columns, 2 * of.crackable());
  const double later = std::min(all, rounds.columns * static_cast<double>(most_whole_columns));
  const double systems = of.iterates ? 2 : 1;
  MemoryPrediction out;
  out.factorises_anew = true;
  out.cracked_points = static_cast<std::size_t>(all / 2);
  out.libraries = library_bytes(of, true, of.path.linear.name() != "amesos2");
  double factor = of.solver_bytes, columns = column_bytes(of, of.has_halves() ? all : later);
  const double indefinite = indefinite_bytes(of, rounds.slides) + matrix_bytes(of),
               whole = whole_column_bytes(of, later) + couplings_bytes(all);
  if (indefinite + whole > factor + columns) factor = indefinite, columns = whole;
  out.factor = systems * factor + other_matrix_bytes(of);
  out.columns = systems * (columns + 3 * number * std::pow(rounds.active * all, 2));
  out.vectors = vector_bytes(of, true);
  return out;
}

/// What lies between two courses where neither can be excluded.
MemoryPrediction between(const MemoryPrediction& a, const MemoryPrediction& b) {
  MemoryPrediction out = a;
  out.libraries = std::midpoint(a.libraries, b.libraries);
  out.factor = std::midpoint(a.factor, b.factor);
  out.vectors = std::midpoint(a.vectors, b.vectors);
  out.columns = std::midpoint(a.columns, b.columns);
  return out;
}

/// Whether it takes the path to know if more cracks than is worth updating. Increments of the load end
/// before; so do paths of joints with multipliers, which lock where all blocks but triangles have them.
bool is_course_open(const Case& of) {
  return !of.refactorises() && !of.has_increments && !of.iterates && !of.has_multipliers() &&
         2 * of.crackable() > of.most_columns;
}

/// Points that crack: all where they are few beside the blocks, as on a line.
double likely_points(const Case& of, bool is_open) {
  if (!of.has_columns) return 0;
  if (is_open) return likely_cracks(of.equilibrium);
  return of.crackable() <= most_on_a_line(of) ? of.crackable() : points_of_one_crack(of.equilibrium);
}

}  // namespace

MemoryPrediction predict_memory(const Simulation& simulation) {
  const double until_here = mib * peak_memory_mib();
  const Case of(simulation);
  const bool is_open = is_course_open(of);
  const double cracked = likely_points(of, is_open), at_most = std::min(of.crackable(), of.most_columns / 2);
  const bool ends_at_gauge = of.path.stop.load_below == 0;
  const bool is_much = cracked > at_most || (of.releases && ends_at_gauge);
  const MemoryPrediction alone = updates_alone(of, std::min(cracked, at_most));
  MemoryPrediction out = alone, most = alone;
  if (of.refactorises() || is_open) {
    constexpr double seldom_more = 2.5;
    const MemoryPrediction anew = new_bases(of, {seldom_more, of.releases, 0});
    MemoryPrediction whole = alone;
    whole.libraries = library_bytes(of, true, is_indefinite(of));
    if (of.refactorises() || is_much)
      out = anew;
    else if (of.slides)  // which steps on all unknowns follow, and often with a new base
      out = between(whole, anew);
    most = new_bases(of, {std::numeric_limits<double>::infinity(), of.slides, 1});
  }
  out.until_here = until_here;
  out.least = std::min(out.total(), is_open ? until_here + alone.total() : out.total());
  out.most = std::max(out.total(), is_open ? until_here + most.total() : out.total());
  return out;
}

}  // namespace dda
