#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "create/assembly.h"
#include "create/part_roles.h"
#include "roomgen/base/text.h"
#include "roomgen/lab/suite.h"
#include "create/standing.h"
#include "create/surfaces.h"

namespace roomgen::lab {

namespace {

using create::detail::Assembly;
using create::detail::Part;

constexpr double contact = 0.003;       // chords of round surfaces are up to a millimetre off
constexpr double ground_tolerance = 0.001;
constexpr double size_tolerance = 0.002;
constexpr double same_place = 0.005;
constexpr double even = 0.01;           // how far places may be from an even arrangement
constexpr double alike = 0.02;          // of a side
constexpr double astray = 0.005;        // how far the end of a leg may be beside what it carries
constexpr double least_leg = 0.05;      // shorter ones are glides

bool stands(const SuiteSentence& sentence) {
  return sentence.mount == Mount::floor || sentence.mount == Mount::surface;
}

std::string plain(const std::string& label) {
  return join(words(label), " ");
}

// A back cushion is a cushion.
bool is_called(const std::string& label, const std::string& name) {
  const std::string own = plain(label);
  return own == name || own.ends_with(" " + name);
}

bool bears(const shape::Group& group, const std::string& label) {
  for (const auto& component : group.components) {
    const auto* inner = std::get_if<shape::Group>(&component.solid);
    const std::string own = component.label.empty() ? label : component.label;
    if (inner ? bears(*inner, own) && plain(own) == plain(label) : plain(own) == plain(label))
      return true;
  }
  return false;
}

int copies_of(const shape::Component& component) {
  int count = 1;
  for (const auto& operation : component.operations) {
    if (std::holds_alternative<shape::Mirror>(operation)) count *= 2;
    if (const auto* array = std::get_if<shape::Array>(&operation)) count *= array->count;
    if (const auto* radial = std::get_if<shape::Radial>(&operation)) count *= radial->count;
    count = std::min(count, 1'000'000);
  }
  return count;
}

// Groups whose label none of their bodies bears count as one more: a back of posts and rails.
void add_groups(const std::vector<shape::Component>& components, int times,
                std::vector<std::string>& labels) {
  for (const auto& component : components) {
    const auto* group = std::get_if<shape::Group>(&component.solid);
    if (!group) continue;
    const int made =
        std::min(times * copies_of(component), static_cast<int>(shape::max_components));
    if (!component.label.empty() && !bears(*group, component.label))
      labels.insert(labels.end(), static_cast<std::size_t>(made), component.label);
    add_groups(group->components, made, labels);
  }
}

std::vector<std::string> labels_of(const CreatedObject& object) {
  std::vector<std::string> labels;
  for (const auto& body : object.shape.bodies) labels.push_back(body.label);
  add_groups(object.program.components, 1, labels);
  return labels;
}

std::string range_text(const WantedPart& part) {
  if (!part.most) return "at least " + std::to_string(part.least);
  if (part.least == *part.most) return std::to_string(part.least);
  return std::to_string(part.least) + " to " + std::to_string(*part.most);
}

// All that touch, directly or through others; the first has number 0.
std::vector<int> numbered_wholes(const std::vector<std::vector<std::size_t>>& contacts) {
  std::vector<int> whole(contacts.size(), -1);
  int count = 0;
  for (std::size_t start = 0; start < contacts.size(); ++start) {
    if (whole[start] >= 0) continue;
    std::vector<std::size_t> waiting = {start};
    whole[start] = count;
    while (!waiting.empty()) {
      const std::size_t part = waiting.back();
      waiting.pop_back();
      for (const std::size_t next : contacts[part])
        if (whole[next] < 0) {
          whole[next] = count;
          waiting.push_back(next);
        }
    }
    ++count;
  }
  return whole;
}

bool is_leg(const Part& part) {
  return create::detail::is_one_of(part.label, {"leg", "foot"}) &&
         part.box().size().z() >= least_leg;
}

/// Measures one thing.
class Assessor {
 public:
  Assessor(const SuiteSentence& sentence, const CreatedObject& object)
      : sentence_(sentence),
        object_(object),
        surfaces_(Assembly::of(create::separate_surfaces(object.shape), contact)),
        bodies_(Assembly::of(object.shape, contact)),
        contacts_(bodies_.contacts()) {
    for (const auto& part : bodies_.parts()) low_ = std::min(low_, part.box().low.z());
  }

  Assessment assess() {
    result_.made = true;
    count_parts();
    if (bodies_.parts().empty()) {
      result_.failures.push_back("has no surface");
      return result_;
    }
    check_connected();
    if (stands(sentence_)) {
      check_grounded();
      check_supported();
      check_stable();
    }
    check_symmetric();
    check_size();
    return result_;
  }

 private:
  void set(Check check, bool passed, const std::string& what = "") {
    auto& known = result_.checks[static_cast<std::size_t>(check)];
    known = known.value_or(true) && passed;
    if (!passed) result_.failures.push_back(std::string(name(check)) + ": " + what);
  }

  void count_parts() {
    const auto labels = labels_of(object_);
    result_.parts_asked = static_cast<int>(sentence_.parts.size());
    for (const auto& part : sentence_.parts) {
      const auto count = std::count_if(labels.begin(), labels.end(), [&](const auto& label) {
        return std::any_of(part.labels.begin(), part.labels.end(),
                           [&](const auto& name) { return is_called(label, name); });
      });
      const bool right = count >= part.least && (!part.most || count <= *part.most);
      result_.parts_right += right;
      if (!right)
        result_.failures.push_back("parts: " + join(part.labels, " or ") + ": " +
                                   std::to_string(count) + ", not " + range_text(part));
    }
  }

  void check_connected() {
    const auto whole = numbered_wholes(surfaces_.contacts());
    const int wholes = 1 + *std::max_element(whole.begin(), whole.end());
    set(Check::connected, wholes == 1, "falls into " + std::to_string(wholes));
  }

  void check_grounded() {
    set(Check::grounded, std::abs(low_) <= ground_tolerance,
        "the lowest point is at " + format_number(1000.0 * low_, 1) + " mm");
    int hanging = 0;
    for (std::size_t k = 0; k < bodies_.parts().size(); ++k)
      hanging += is_leg(bodies_.parts()[k]) && !stands_on_something(k);
    set(Check::grounded, hanging == 0,
        std::to_string(hanging) + (hanging == 1 ? " leg hangs" : " legs hang") + " in the air");
  }

  // On the ground, or on a castor or a step.
  bool stands_on_something(std::size_t k) const {
    const Bounds3& box = bodies_.parts()[k].box();
    if (box.low.z() <= low_ + contact) return true;
    return std::any_of(contacts_[k].begin(), contacts_[k].end(), [&](std::size_t under) {
      return bodies_.parts()[under].box().center().z() < box.low.z() + 0.01;
    });
  }

  void check_supported() {
    const auto whole = numbered_wholes(contacts_);
    std::vector<bool> on_ground(bodies_.parts().size());
    for (std::size_t k = 0; k < whole.size(); ++k)
      if (bodies_.parts()[k].box().low.z() <= low_ + contact)
        on_ground[static_cast<std::size_t>(whole[k])] = true;
    int floating = 0, idle = 0;
    for (std::size_t k = 0; k < whole.size(); ++k) {
      floating += !on_ground[static_cast<std::size_t>(whole[k])];
      idle += is_leg(bodies_.parts()[k]) && !carries(k);
    }
    set(Check::supported, floating == 0, std::to_string(floating) + " rest on nothing");
    set(Check::supported, idle == 0,
        std::to_string(idle) + (idle == 1 ? " leg is" : " legs are") + " not under what it carries");
  }

  // Something that is above the leg's middle touches it; of what is above its end it meets a part.
  bool carries(std::size_t leg) const {
    const Bounds3& own = bodies_.parts()[leg].box();
    const Vec2 end = upper_end(bodies_.parts()[leg]);
    bool any = false, ends_beside = false;
    for (const std::size_t other : contacts_[leg]) {
      const Part& load = bodies_.parts()[other];
      if (load.box().center().z() <= own.center().z()) continue;
      const bool above = load.box().high.z() > own.high.z() - 0.02 && load.box().size().x() > 0.02 &&
                         load.box().size().y() > 0.02;
      any = true;
      if (!above) continue;
      if (depth_in(create::detail::plan_outline(load), end) >= -astray) return true;
      ends_beside = true;
    }
    return any && !ends_beside;
  }

  static Vec2 upper_end(const Part& part) {
    const double from = part.box().high.z() - std::max(0.005, 0.05 * part.box().size().z());
    Bounds3 end;
    for (const auto& position : part.solid.mesh().positions)
      if (position.z() >= from) end.add(position.cast<double>());
    return end.center().head<2>();
  }

  void check_stable() {
    const auto standing = create::detail::standing(bodies_.parts(), bodies_.contact());
    set(Check::stable, standing.stable(),
        "the centre of mass is " + format_number(-1000.0 * standing.margin, 0) +
            " mm outside what stands on the ground");
  }

  void check_symmetric() {
    std::map<std::string, std::vector<const Part*>> families;
    for (const auto& part : bodies_.parts())
      if (create::detail::is_foot(part.label) ||
          create::detail::is_one_of(part.label, {"arm", "armrest"}))
        families[without_numbers(part.name)].push_back(&part);
    for (const auto& [family, parts] : families)
      if (parts.size() > 1) check_family(plain(parts.front()->label), parts);
  }

  // "legs.leg-2.tapered" is a copy of "legs.leg-0.tapered".
  static std::string without_numbers(const std::string& name) {
    std::string result;
    for (const char c : name)
      if ((c < '0' || c > '9') && c != '-' && c != '_') result += c;
    return result;
  }

  void check_family(const std::string& label, const std::vector<const Part*>& parts) {
    const std::string who = std::to_string(parts.size()) + " of the part " + label;
    const bool same = std::all_of(parts.begin(), parts.end(), [&](const Part* part) {
      return are_alike(*parts.front(), *part);
    });
    std::vector<Vec3> places;
    for (const Part* part : parts) places.push_back(part->box().center());
    set(Check::symmetric, same, who + " are of different sizes");
    set(Check::symmetric, are_apart(places), who + " are not each in a place of their own");
    set(Check::symmetric, are_even(places), who + " do not lie evenly");
  }

  // Turned copies have other boxes, but the same volume and height.
  static bool are_alike(const Part& a, const Part& b) {
    const double volume = std::max(a.volume, b.volume);
    return std::abs(a.volume - b.volume) <= 3.0 * alike * volume + 1e-9 &&
           std::abs(a.box().size().z() - b.box().size().z()) <=
               size_tolerance + alike * a.box().size().z();
  }

  static bool are_apart(const std::vector<Vec3>& places) {
    for (std::size_t a = 0; a < places.size(); ++a)
      for (std::size_t b = a + 1; b < places.size(); ++b)
        if ((places[a] - places[b]).norm() < same_place) return false;
    return true;
  }

  // Some mirror image or turn about their middle leaves them where they are.
  static bool are_even(const std::vector<Vec3>& places) {
    Vec3 middle = Vec3::Zero();
    for (const auto& place : places) middle += place / static_cast<double>(places.size());
    const double angle = 2.0 * pi / static_cast<double>(places.size());
    Eigen::Matrix2d mirror_x, mirror_y, diagonal, other, turn, half;
    mirror_x << -1, 0, 0, 1;
    mirror_y << 1, 0, 0, -1;
    diagonal << 0, 1, 1, 0;
    other << 0, -1, -1, 0;
    half << -1, 0, 0, -1;
    turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    for (const Eigen::Matrix2d& map : {mirror_x, mirror_y, diagonal, other, turn, half})
      if (std::all_of(places.begin(), places.end(), [&](const Vec3& place) {
            Vec3 image = place;
            image.head<2>() = middle.head<2>() + map * (place - middle).head<2>();
            return std::any_of(places.begin(), places.end(), [&](const Vec3& there) {
              return (there - image).norm() <= even;
            });
          }))
        return true;
    return false;
  }

  void check_size() {
    static constexpr std::array<const char*, 3> sides = {"width", "depth", "height"};
    const Vec3 size = shape::bounds(object_.shape).size();
    std::vector<std::string> wrong;
    for (int axis = 0; axis < 3; ++axis) {
      const double least = sentence_.least[axis], most = sentence_.most[axis];
      if (size[axis] >= least - size_tolerance && size[axis] <= most + size_tolerance) continue;
      wrong.push_back(std::string(sides[static_cast<std::size_t>(axis)]) + " " +
                      format_number(size[axis]) + " m, not " + format_number(least) + " to " +
                      format_number(most));
    }
    set(Check::size, wrong.empty(), join(wrong, "; "));
  }

  const SuiteSentence& sentence_;
  const CreatedObject& object_;
  Assembly surfaces_, bodies_;  ///< each closed surface by itself; as they are labelled
  std::vector<std::vector<std::size_t>> contacts_;  ///< of bodies_
  double low_ = 1e300;
  Assessment result_;
};

}  // namespace

bool Assessment::perfect() const {
  return made && parts_right == parts_asked &&
         std::all_of(std::begin(checks), std::end(checks),
                     [](const auto& check) { return check.value_or(true); });
}

Assessment assess(const SuiteSentence& sentence, const CreatedObject& object) {
  return Assessor(sentence, object).assess();
}

Assessment assess(const SuiteSentence& sentence, const Creation& creation) {
  Assessment result = assess(sentence, creation.objects.front());
  std::size_t things = 0;
  for (const auto& object : creation.objects)
    things += static_cast<std::size_t>(std::max(1, object.description.count));
  if (things == 1) return result;
  result.checks[static_cast<std::size_t>(Check::connected)] = false;
  result.failures.push_back("connected: made as " + std::to_string(things) + " things");
  return result;
}

Assessment not_made(const SuiteSentence& sentence, const std::string& why) {
  Assessment result;
  result.parts_asked = static_cast<int>(sentence.parts.size());
  result.failures = {"not made: " + why};
  for (const Check check : {Check::connected, Check::size})
    result.checks[static_cast<std::size_t>(check)] = false;
  if (stands(sentence))
    for (const Check check : {Check::grounded, Check::supported, Check::stable})
      result.checks[static_cast<std::size_t>(check)] = false;
  return result;
}

}  // namespace roomgen::lab
