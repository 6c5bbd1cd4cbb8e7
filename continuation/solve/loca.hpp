#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "continuation/solve/equations/equations.hpp"

namespace dda {

/// How NOX goes from one iterate to the next.
enum class Method {
  newton,       ///< Newton's direction in full
  line_search,  ///< Newton's direction, shortened until the residual falls
  walk          ///< to the end of a finite walk (WalkedEquations)
};

/// A solve that is asked of LOCA.
struct Solve {
  Equations& equations;
  Iterate guess;
  double step = 0;  ///< s of the control at its end
  Method method = Method::newton;
};

/// What it came to.
struct Solved {
  bool converged = false;
  std::vector<double> x;
  double load_factor = 0;
  int iterations = 0;
  std::string reason = {};  ///< why it failed
};

/// One LOCA::Stepper over all steps of a path in some unknowns: natural continuation in the abstract
/// parameter s of the controls, closed by the control as a LOCA constraint with unknown λ.
///
/// Each solve is a try of its next step, which NOX converges from the guess; the stepper refuses it when
/// another follows that is not accepted, and counts those that are.
class LocaStepper {
 public:
  virtual ~LocaStepper() = default;
  virtual Solved solve(const Solve& wanted) = 0;
  /// The next point of the path is here, where a solve has converged.
  virtual void accept(const Iterate& at) = 0;
  /// Accepted steps, as LOCA counts them.
  virtual int num_steps() const = 0;
};

/// What the lists of a stepper say beside what is always so.
struct LocaSettings {
  std::string line_search = "Full Step";  ///< of Method::newton, by NOX's name
  double reduction = 0.5;                 ///< of "Backtrack"
  int output = 0;                         ///< "Output Information"
  std::filesystem::path log = {};         ///< a file that is appended to; none: nothing is printed
};

/// A stepper, from a module that is loaded when it is first asked for. Throws std::runtime_error with the
/// loader's words.
std::unique_ptr<LocaStepper> make_loca_stepper(const LocaSettings& settings);

/// A parameter of a Teuchos::ParameterList: the names of the lists that it is in, and its own; its value as
/// text.
struct ListEntry {
  std::vector<std::string> lists;
  std::string name;
  enum class Type { boolean, integer, number, text } type = Type::text;
  std::string value;
};

/// The parameters of a list in an XML file, in its order. Throws std::runtime_error with what Teuchos says.
std::vector<ListEntry> read_parameter_list(const std::filesystem::path& file);
/// The XML text of a list.
std::string parameter_list_text(const std::vector<ListEntry>& entries);

}  // namespace dda
