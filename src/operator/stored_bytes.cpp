#include "operator/stored_bytes.hpp"

#include <algorithm>
#include <cstring>

namespace softwet {

namespace {

using Bytes = Kokkos::View<std::byte*, Exec>;

struct StoredTable {
  std::vector<std::byte> bytes;
  Bytes copy;
  long last_use = 0;
};

struct TableStore {
  StoredTable entry[16];
  long uses = 0, copies = 0;
};

TableStore& table_store() {
  static TableStore kept;
  static const bool released_in_time = [] {
    Kokkos::push_finalize_hook([] { kept = {}; });
    return true;
  }();
  (void)released_in_time;
  return kept;
}

void copy_table(StoredTable& to, const std::byte* bytes, std::size_t count) {
  to.bytes.assign(bytes, bytes + count);
  if (to.copy.extent(0) < count) to.copy = Bytes(Kokkos::view_alloc("tables", Kokkos::WithoutInitializing), count);
  const Kokkos::View<const std::byte*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> from(bytes, count);
  Kokkos::deep_copy(Kokkos::subview(to.copy, Kokkos::make_pair(std::size_t(0), count)), from);
}

}  // namespace

const std::byte* stored_bytes(const std::byte* bytes, std::size_t count) {
  TableStore& s = table_store();
  ++s.uses;
  StoredTable* oldest = s.entry;
  for (StoredTable& entry : s.entry) {
    if (entry.bytes.size() == count && std::memcmp(entry.bytes.data(), bytes, count) == 0) {
      entry.last_use = s.uses;
      return entry.copy.data();
    }
    if (entry.last_use < oldest->last_use) oldest = &entry;
  }
  copy_table(*oldest, bytes, count);
  oldest->last_use = s.uses;
  ++s.copies;
  return oldest->copy.data();
}

long copies_of_bytes() { return table_store().copies; }

}  // namespace softwet
