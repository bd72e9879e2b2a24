#include <algorithm>
#include <cassert>

#include "roomgen/lab/program.h"

namespace roomgen::lab {

const std::vector<ProgramOpForm>& program_op_forms() {
  using Op = ProgramOp;
  static const std::vector<ProgramOpForm> forms = {
      {Op::count, "count", "S", false, "how many members the set has"},
      {Op::footprint, "footprint", "S", false,
       "what its members cover of the floor, seen from above, counted once where several lie over each other, in m2"},
      {Op::volume, "volume", "S", false, "the sum of the volumes of its members' boxes, in m3"},
      {Op::area, "area", "S", false, "the area of the room's floor; of things, their footprint; in m2"},
      {Op::occupancy, "occupancy", "S", false,
       "the share of the room's floor that its members cover, without rugs and what does not stand on the floor"},
      {Op::seats, "seats", "S", false, "how many people can sit on its members"},
      {Op::distance, "dist", "SSs", false,
       "the least distance of a member of the first set from one of the second, or from that face of it, in m"},
      {Op::gap, "gap", "S", false, "the least distance of two of its members from each other, in m"},
      {Op::access, "access", "SSa", false,
       "how deep members of the second set reach at most into the free space before those of the first, in m"},
      {Op::angle, "angle", "SSs", false,
       "how far each member of the first set is turned from the nearest side of one of the second, added up: 0 "
       "parallel, 0.5 at right angles"},
      {Op::focus, "focus", "SS", false,
       "how far each member of the first set looks away from the second, added up: 0 straight at it, 1 straight away"},
      {Op::center, "center", "S", false,
       "how far each of its members is from the middle of what carries it, added up, in m"},
      {Op::reflection, "reflect", "SS", false,
       "how far the members of the first set are from mirror images of each other across the second: 0 symmetrical, "
       "below 1"},
      {Op::rotation, "rotasym", "S", false, "how far its members are from standing evenly around their middle: 0 evenly"},
      {Op::coplanarity, "coplanar", "S", false, "how far its members are from having their fronts or backs in one plane"},
      {Op::add, "+", "N+", false, "the sum"},
      {Op::multiply, "*", "N+", false, "the product"},
      {Op::subtract, "-", "NN", false, "the first less the second"},
      {Op::divide, "safediv", "NN", false, "the first over the second; 0 over 0 is 0, anything else over 0 is 1"},
      {Op::power, "pow", "NN", false, "the first to the power of the second"},
      {Op::absolute, "abs", "N", false, "without its sign"},
      {Op::logarithm, "log", "N", false, "the natural logarithm"},
      {Op::least, "min", "N+", false, "the least of them"},
      {Op::greatest, "max", "N+", false, "the greatest of them"},
      {Op::clamp, "clamp", "NLL", false, "the number, kept between both bounds"},
      {Op::hinge, "hinge", "NLL", false, "how far the number is outside both bounds: 0 between them"},
      {Op::mean, "mean", "vSN", false, "the mean of the number over the members of the set, each named by the variable"},
      {Op::sum, "sum", "vSN", false, "the sum of the number over the members of the set, each named by the variable"},
      {Op::minimize, "minimize", "LN", false, "the number, times the weight, is wanted small"},
      {Op::maximize, "maximize", "LN", false, "the number, times the weight, is wanted large"},
      {Op::all_of, "and", "B+", true, "all of them hold"},
      {Op::any_of, "or", "B+", true, "one of them holds"},
      {Op::not_of, "not", "B", true, "it does not hold"},
      {Op::for_all, "all", "vSB", true, "it holds for every member of the set, each named by the variable"},
      {Op::within, "in", "NLL", true, "the number is between both bounds, or equal to one"},
      {Op::equal, "==", "NN", true, "they are equal"},
      {Op::unequal, "!=", "NN", true, "they differ"},
      {Op::at_least, ">=", "NN", true, "the first is at least the second"},
      {Op::at_most, "<=", "NN", true, "the first is at most the second"},
      {Op::more, ">", "NN", true, "the first is more than the second"},
      {Op::less, "<", "NN", true, "the first is less than the second"},
  };
  return forms;
}

const ProgramOpForm* find_op_form(std::string_view name) {
  const auto& forms = program_op_forms();
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const auto& form) { return form.name == name; });
  return found == forms.end() ? nullptr : &*found;
}

const ProgramOpForm& form_of(ProgramOp op) {
  const auto& forms = program_op_forms();
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const auto& form) { return form.op == op; });
  assert(found != forms.end());
  return *found;
}

}  // namespace roomgen::lab
