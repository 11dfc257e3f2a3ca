// Schema, the table of quantities with units. A case has none of them: it has the keys that follow from them.
#include <algorithm>

#include "casefile/schema/laboratory_quantities.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {

const std::vector<LaboratoryQuantity>& laboratory_quantities() {
  using P = PhysicalScene;
  using enum Quantity;
  static const std::vector<LaboratoryQuantity> all{
      {"length",
       length,
       &P::length,
       {},
       "1 mm",
       "The length that is 1 in the case, L0. Lengths of the case without a key here are in this unit."},
      {"surface_tension",
       surface_tension,
       &P::surface_tension,
       {},
       "72 mN/m",
       "Surface tension of the liquid. It gives the scale a."},
      {"density", density, &P::density, {}, "1000 kg/m3", "Density of the liquid. It gives the scale b."},
      {"viscosity", viscosity, &P::viscosity, {"fluid.viscosity"}, "1 mPa.s", "Viscosity of the liquid."},
      {"capillarity", length, &P::half_width, {"fluid.capillarity"}, "10 um", "Half the width of the interface."},
      {"radius", length, &P::radius, {"droplet[].radius"}, "500 um", "Radius of the first droplet."},
      {"thickness", length, &P::thickness, {"substrate.thickness"}, "100 um", "Thickness of the solid."},
      {"solid_density",
       density,
       &P::solid_density,
       {"substrate.density"},
       "970 kg/m3",
       "Density of the solid; without it the solid is as dense as the liquid."},
      {"young", stress, &P::young, {"substrate.young", "substrate.density"}, "3 kPa", "Young modulus of the solid."},
      {"solid_surface_tension",
       surface_tension,
       &P::solid_tension,
       {"substrate.surface_tension"},
       "31 mN/m",
       "Surface tension of the dry solid."},
      {"wet_surface_tension",
       surface_tension,
       &P::wet_tension,
       {"substrate.surface_tension_wet"},
       "36 mN/m",
       "Surface tension of the solid below liquid."},
      {"solid_viscosity",
       viscosity,
       &P::solid_viscosity,
       {"substrate.viscosity"},
       "1 Pa.s",
       "Shear viscosity of the solid."}};
  return all;
}

bool may_follow(const std::string& key) {
  const auto& all = laboratory_quantities();
  return std::any_of(all.begin(), all.end(), [&](const LaboratoryQuantity& quantity) {
    return std::find(quantity.keys.begin(), quantity.keys.end(), key) != quantity.keys.end();
  });
}

std::vector<Key> laboratory_keys() {
  std::vector<Key> keys;
  for (const LaboratoryQuantity& quantity : laboratory_quantities()) {
    std::string follow;
    for (const std::string& key : quantity.keys) follow += (follow.empty() ? " It gives " : " and ") + key;
    Key key;
    key.name = quantity.key();
    key.kind = Kind::text;
    key.required = keys.size() < quantities_of_scales;
    key.example = in_quotes(quantity.example);
    key.help = quantity.help + (follow.empty() ? "" : follow + ".");
    key.bind.set = [](Case&, std::size_t, const Value&) {};
    key.bind.get = [](const Case&, std::size_t) { return Value(std::string()); };
    key.default_note = "none";
    keys.push_back(key);
  }
  return keys;
}

}  // namespace softwet
