#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "models/body/functional.hpp"

namespace dda {

/// Displacements of all nodes, of which at first only those of some may be known, as a step needs them: the
/// rest is computed when it is asked for. Copies share what they hold until one of them is changed.
class Displacements {
 public:
  /// How the rest is computed.
  class Completion {
   public:
    virtual ~Completion() = default;
    /// The displacements of all nodes.
    virtual std::vector<double> all() const = 0;
  };
  /// Nodes that are known, by their number.
  using Nodes = std::shared_ptr<const std::vector<bool>>;

 private:
  struct Content {
    std::vector<double> values;
    Nodes known = nullptr;
    std::unique_ptr<Completion> completion = nullptr;  ///< none where all are known
    std::optional<double> dead_work = {};

    void complete();
  };

 public:
  /// The same ones later, if they still live then.
  class Pending {
   public:
    explicit Pending(const Displacements& of) : content_(of.content_) {}
    bool is_over() const { return content_.expired(); }
    void complete() const {
      if (const auto content = content_.lock()) content->complete();
    }

   private:
    std::weak_ptr<Content> content_;
  };

  Displacements(std::vector<double> all = {});
  /// Known at these nodes only. `dead_work` is their product with the dead forces of their stage [FL].
  Displacements(std::vector<double> values, Nodes known, std::unique_ptr<Completion> completion,
                std::optional<double> dead_work = {});

  std::size_t size() const { return content_->values.size(); }
  bool empty() const { return size() == 0; }
  bool are_all_known() const { return !content_->completion; }
  bool know(std::size_t node) const { return are_all_known() || (*content_->known)[node]; }
  bool know(const Functional& gauge) const;

  /// Of all nodes.
  const std::vector<double>& all() const;
  operator const std::vector<double>&() const { return all(); }
  const double* data() const { return all().data(); }
  auto begin() const { return all().begin(); }
  auto end() const { return all().end(); }
  double operator[](std::size_t i) const { return all()[i]; }

  /// Right at the watched nodes of their stage; elsewhere it may be anything. Stays where it is when the rest is computed.
  const std::vector<double>& watched() const { return content_->values; }
  /// Right where a gauge asks.
  const std::vector<double>& asked_by(const Functional& gauge) const {
    return know(gauge) ? watched() : all();
  }
  /// Of solutions put together from kept ones, which know it whatever else they know.
  const std::optional<double>& dead_work() const { return content_->dead_work; }
  bool is_same_as(const Displacements& other) const { return content_ == other.content_; }

  /// Moved along a direction where they are known.
  Displacements moved(double amount, std::span<const double> direction) const;

 private:
  std::shared_ptr<Content> content_;
};

}  // namespace dda
