// Where operands of instructions lie: registers, constants, addresses of variables, special registers.
#include <algorithm>
#include <map>
#include <string_view>

#include "translate.hpp"

namespace emulate {

Place Translator::constant(std::uint64_t bits, int bytes) {
  if (bytes == 4) bits &= 0xffffffffu;
  const auto [found, fresh] =
      constants_.try_emplace({bits, bytes}, static_cast<std::uint32_t>(k_.constants.size() * 8));
  if (fresh) k_.constants.insert(k_.constants.end(), 32, bytes == 8 ? bits : bits | bits << 32);
  return {1, found->second};
}

std::uint64_t Translator::address(const Statement& s, int n, const std::string& name) {
  const Instance& in = instances_[n];
  if (const auto found = in.local.find(name); found != in.local.end()) return static_cast<std::uint64_t>(found->second);
  if (const auto found = params_.find(name); in.kernel && found != params_.end())
    return static_cast<std::uint64_t>(found->second);
  if (const auto found = shared_.find(in.function->name + name); found != shared_.end())
    return static_cast<std::uint64_t>(found->second);
  if (const auto found = shared_.find(name); found != shared_.end()) return static_cast<std::uint64_t>(found->second);
  for (const Variable& v : module_.variables())
    if (v.name == name && v.space == Space::shared && v.external) return static_cast<std::uint64_t>(dynamic_at_);
  if (const auto found = symbols_.all.find(name); found != symbols_.all.end()) return found->second.address;
  fail(s, "no variable " + name);
}

Place Translator::special(const Statement& s, const std::string& name) {
  static const std::map<std::string_view, std::uint32_t> names = {{"%tid.x", tid_x},
                                                                  {"%tid.y", tid_y},
                                                                  {"%tid.z", tid_z},
                                                                  {"%ntid.x", ntid_x},
                                                                  {"%ntid.y", ntid_y},
                                                                  {"%ntid.z", ntid_z},
                                                                  {"%ctaid.x", ctaid_x},
                                                                  {"%ctaid.y", ctaid_y},
                                                                  {"%ctaid.z", ctaid_z},
                                                                  {"%nctaid.x", nctaid_x},
                                                                  {"%nctaid.y", nctaid_y},
                                                                  {"%nctaid.z", nctaid_z},
                                                                  {"%laneid", laneid},
                                                                  {"%warpid", warpid},
                                                                  {"%nwarpid", nwarpid},
                                                                  {"%smid", smid},
                                                                  {"%nsmid", nsmid},
                                                                  {"%gridid", gridid},
                                                                  {"%lanemask_eq", lanemask_eq},
                                                                  {"%lanemask_le", lanemask_le},
                                                                  {"%lanemask_lt", lanemask_lt},
                                                                  {"%lanemask_ge", lanemask_ge},
                                                                  {"%lanemask_gt", lanemask_gt},
                                                                  {"%dynamic_smem_size", dynamic_shared},
                                                                  {"%total_smem_size", total_shared},
                                                                  {"%clock", clock32},
                                                                  {"%clock64", clock64},
                                                                  {"%globaltimer", clock64}};
  const auto found = names.find(name);
  if (found == names.end()) throw Problem("special register " + name + " in '" + s.opcode + "'");
  return {2, found->second * 128};
}

Place Translator::place(const Statement& s, int n, const Operand& o, int bytes) {
  switch (o.kind) {
    case Operand::reg:
      return {0, place_of_[o.reg_index + instances_[n].first_register]};
    case Operand::number:
      return constant(o.bits, bytes);
    case Operand::name:
      return constant(address(s, n, o.text) + static_cast<std::uint64_t>(o.offset), bytes);
    case Operand::special:
      if (o.text == "%gridid" && bytes == 8) return constant(0, 8);
      return special(s, o.text);
    case Operand::sink:
      return {0, nowhere};
    default:
      fail(s, "an operand");
  }
}

std::uint32_t Translator::result(int n, const Operand& o) {
  return o.kind == Operand::reg ? place_of_[o.reg_index + instances_[n].first_register] : nowhere;
}

int Translator::width(int n, const Operand& o) {
  if (o.kind == Operand::reg) {
    const Type t = types_[o.reg_index + instances_[n].first_register];
    return t == Type::pred ? 1 : std::max(4, size_of(t));
  }
  return 0;
}

int Translator::number_bytes(const Statement& s, std::size_t index) {
  const std::string& op = s.words[0];
  Type type = Type::none, first = Type::none;
  for (auto word = s.words.rbegin(); word != s.words.rend(); ++word)
    if (const auto t = type_named(*word)) {
      if (type == Type::none) type = *t;
      first = *t;
    }
  const int bytes = std::max(4, size_of(type));
  if ((op == "shl" || op == "shr") && index == 2) return 4;
  if (op == "mad" && s.has("wide") && index == 3) return size_of(type) == 2 ? 4 : 8;
  if (op == "bfe" && index >= 2) return 4;
  if (op == "bfi" && index >= 3) return 4;
  if (op == "slct") return index == 3 ? std::max(4, size_of(type)) : std::max(4, size_of(first));
  return bytes;
}

}  // namespace emulate
