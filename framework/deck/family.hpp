#pragma once

#include <map>
#include <stdexcept>

#include "framework/deck/schema.hpp"

namespace dda {

/// One registered member of a family, as the user sees it.
struct FamilyMember {
  std::string name;                          ///< in the deck: `type: name`
  std::shared_ptr<const SchemaBase> schema;  ///< its parameters; its text is the member's text
  virtual ~FamilyMember() = default;
};

/// A family without its C++ types: what explain, the JSON schema and contract tests run over.
class FamilyBase {
 public:
  FamilyBase(std::string name, std::string text);
  FamilyBase(const FamilyBase&) = delete;
  FamilyBase& operator=(const FamilyBase&) = delete;
  virtual ~FamilyBase();

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  /// Every member, in alphabetical order.
  std::vector<const FamilyMember*> entries() const;
  const FamilyMember* find(const std::string& name) const;

 protected:
  struct Selection {
    const FamilyMember* member;
    Node parameters;  ///< the deck's map without `type`
  };
  /// Which member a node `{type: name, ...}` or `name` selects; a finding when there is none of that name.
  std::optional<Selection> select(const Node& node, const Reading& reading) const;
  void insert(std::unique_ptr<FamilyMember> member);

 private:
  std::string name_, text_;
  std::map<std::string, std::unique_ptr<FamilyMember>> members_;
};

/// Every family of the program, in alphabetical order.
std::vector<const FamilyBase*> all_families();

template <class Product, class... Context>
class Family;

/// What a deck selected from a family: a member and its parameters. Cheap to copy; empty when
/// default-constructed.
template <class Product, class... Context>
class Choice {
 public:
  Choice() = default;

  bool is_empty() const { return member_ == nullptr; }
  explicit operator bool() const { return !is_empty(); }
  /// The registry name, "" when empty.
  std::string name() const { return member_ ? member_->name : ""; }
  const Position& where() const { return where_; }
  /// Builds the selected thing. The choice must not be empty.
  std::unique_ptr<Product> make(Context... context) const {
    if (!member_) throw std::logic_error("make() of an empty Choice");
    return member_->make(parameters_.get(), context...);
  }
  /// `{type: name, ...}` with every parameter, or the bare name when it has none; null when empty.
  Node echo() const;

 private:
  friend class Family<Product, Context...>;
  struct Member : FamilyMember {
    std::function<std::shared_ptr<const void>(const Node&, const Reading&)> read;  ///< null when wrong
    std::function<std::unique_ptr<Product>(const void*, Context...)> make;
  };

  const Member* member_ = nullptr;  ///< members live as long as the program
  std::shared_ptr<const void> parameters_;
  Position where_;
};

/// The registry of things a deck selects by name: one object per family, made by one function.
///
///     Family<InterfaceLaw>& interface_laws() {
///       static Family<InterfaceLaw> family("law", "What an interface does with its opening.");
///       return family;
///     }
///
/// In the deck a member is `law: {type: linear_softening, tensile_strength: 3}` or, all defaults, `law:
/// bonded`. Context is what makers need beside their parameters.
template <class Product, class... Context>
class Family : public FamilyBase {
 public:
  using Selected = Choice<Product, Context...>;
  using FamilyBase::FamilyBase;

  /// Registers a member; use DDA_REGISTER. `make` takes (const Parameters&, Context...) and gives a
  /// unique_ptr<Product>.
  template <class Parameters, class Maker>
  bool add(std::string name, const Schema<Parameters>& schema, Maker make);

  /// Reads a choice as it stands in a deck; InputError when wrong.
  Selected choose(const Node& node) const;
  /// A member with parameters as the deck would give them, without `type`.
  Selected choose(const std::string& name, Node parameters = Node::map()) const;

  Kind<Selected> kind() const {
    auto read = [this](const Node& node, const Reading& reading) { return this->read(node, reading); };
    return {KindInfo{.form = KindInfo::Form::family, .family = this}, read,
            [](const Selected& c) { return c.echo(); }};
  }

 private:
  using Member = typename Selected::Member;
  std::optional<Selected> read(const Node& node, const Reading& reading) const;
};

/// The maker of a member that is one class: with its parameters and the family's context, as far as its
/// constructor takes them.
template <class Member>
inline constexpr auto make_of =
    []<class Parameters, class... Context>(const Parameters& p, Context&&... context) {
      if constexpr (std::is_constructible_v<Member, const Parameters&, Context...>)
        return std::make_unique<Member>(p, std::forward<Context>(context)...);
      else if constexpr (std::is_constructible_v<Member, const Parameters&>)
        return std::make_unique<Member>(p);
      else
        return std::make_unique<Member>();
    };

/// Of members that have none.
struct NoParameters {};

/// Registers a member of a family in its .cpp: DDA_REGISTER(treatments(), "penalty", schema(), make_of<Penalty>)
#define DDA_REGISTER(family, name, schema, make) DDA_REGISTER_AT(family, name, schema, make, __COUNTER__)
#define DDA_REGISTER_AT(family, name, schema, make, number) \
  DDA_REGISTER_AS(family, name, schema, make, number)
#define DDA_REGISTER_AS(family, name, schema, make, number)                           \
  namespace {                                                                         \
  [[maybe_unused]] const bool registered_##number = (family).add(name, schema, make); \
  }

template <class Product, class... Context>
Node Choice<Product, Context...>::echo() const {
  if (!member_) return {};
  if (member_->schema->parameters().empty()) return Node::scalar(member_->name);
  Node node = Node::map();
  node.set("type", Node::scalar(member_->name));
  for (NodeEntry& entry : member_->schema->echo_from(parameters_.get()).entries)
    node.entries.push_back(std::move(entry));
  return node;
}

template <class Product, class... Context>
template <class Parameters, class Maker>
bool Family<Product, Context...>::add(std::string name, const Schema<Parameters>& schema, Maker make) {
  auto member = std::make_unique<Member>();
  auto shared = std::make_shared<const Schema<Parameters>>(schema);
  member->name = std::move(name);
  member->schema = shared;
  member->read = [shared](const Node& node, const Reading& reading) -> std::shared_ptr<const void> {
    auto parameters = std::make_shared<Parameters>();
    if (!shared->read_into(parameters.get(), node, reading)) return nullptr;
    return parameters;
  };
  member->make = [make](const void* parameters, Context... context) -> std::unique_ptr<Product> {
    return make(*static_cast<const Parameters*>(parameters), context...);
  };
  insert(std::move(member));
  return true;
}

template <class Product, class... Context>
auto Family<Product, Context...>::read(const Node& node, const Reading& reading) const
    -> std::optional<Selected> {
  auto selection = select(node, reading);
  if (!selection) return {};
  Selected choice;
  choice.member_ = static_cast<const Member*>(selection->member);
  choice.where_ = node.where;
  choice.parameters_ =
      choice.member_->read(selection->parameters, reading.in(name() + " '" + choice.name() + "'"));
  return choice.parameters_ ? std::optional(std::move(choice)) : std::nullopt;
}

template <class Product, class... Context>
auto Family<Product, Context...>::choose(const Node& node) const -> Selected {
  Findings findings;
  auto choice = read(node, {findings, std::filesystem::path(node.where.file).parent_path(), name(), ""});
  findings.throw_if_any();
  return std::move(*choice);
}

template <class Product, class... Context>
auto Family<Product, Context...>::choose(const std::string& name, Node parameters) const -> Selected {
  parameters.set("type", Node::scalar(name));
  return choose(parameters);
}

}  // namespace dda
