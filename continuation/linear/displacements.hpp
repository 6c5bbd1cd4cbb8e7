#pragma once

#include <memory>
#include <span>
#include <vector>

#include "framework/base/vec2.hpp"
#include "models/body/functional.hpp"

namespace dda {

/// Displacements of all nodes, or the solutions that they are a sum of. Of a sum openings and gauges are told
/// without them, and they are computed when they are asked for. Copies share what they hold.
class Displacements {
 public:
  class Pending;
  /// A sum of solutions that are kept elsewhere.
  class Sum {
   public:
    virtual ~Sum() = default;
    /// n.
    virtual std::size_t size() const = 0;
    /// The displacements of all nodes.
    virtual std::vector<double> all() const = 0;
    /// B d of every active point [L].
    virtual const std::vector<Vec2>& openings() const = 0;
    /// Σ rowᵀ d of the rows of a gauge.
    virtual double product(const Functional& gauge) const = 0;
    /// f_dead · d of the stage [FL].
    virtual double dead_work() const = 0;
    /// a times this and b times the other; null where the solutions are not the same ones.
    virtual std::shared_ptr<const Sum> combined(double a, double b, const Sum& other) const = 0;
    /// Tells who keeps the solutions of displacements that are this sum.
    virtual void note(const Pending& displacements) const = 0;
  };

 private:
  struct Content {
    std::vector<double> values = {};  ///< empty until asked for
    std::shared_ptr<const Sum> sum = nullptr;

    const std::vector<double>& all();
  };

 public:
  /// The same ones later, if they still live then.
  class Pending {
   public:
    explicit Pending(const Displacements& of) : content_(of.content_) {}
    bool is_over() const { return content_.expired(); }
    /// Makes them what they are without the solutions, which are about to go.
    void settle() const;

   private:
    std::weak_ptr<Content> content_;
  };

  Displacements(std::vector<double> all = {})
      : content_(std::make_shared<Content>(Content{std::move(all)})) {}
  Displacements(std::shared_ptr<const Sum> sum);

  std::size_t size() const { return content_->sum ? content_->sum->size() : content_->values.size(); }
  bool empty() const { return size() == 0; }
  bool are_all_known() const { return !content_->values.empty(); }
  /// The sum that they are; null where they are but themselves.
  const Sum* sum() const { return content_->sum.get(); }

  /// Of all nodes. What a sum tells does not hang on whether these were asked for.
  const std::vector<double>& all() const { return content_->all(); }
  operator const std::vector<double>&() const { return all(); }
  const double* data() const { return all().data(); }
  auto begin() const { return all().begin(); }
  auto end() const { return all().end(); }
  double operator[](std::size_t i) const { return all()[i]; }

  double value(const Functional& gauge, double load_factor) const;
  bool is_same_as(const Displacements& other) const { return content_ == other.content_; }

  /// a times these and b times others.
  Displacements combined(double a, double b, const Displacements& others) const;
  /// Moved along a direction.
  Displacements moved(double amount, const Displacements& direction) const {
    return combined(1, amount, direction);
  }
  Displacements scaled(double factor) const { return combined(factor, 0, *this); }

 private:
  std::shared_ptr<Content> content_;
};

}  // namespace dda
