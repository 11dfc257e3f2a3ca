#include "solver/direct/host/front.hpp"

#include <algorithm>

namespace softwet {

std::vector<Run> find_runs(const std::vector<int>& border_in_parent, int own_of_parent) {
  std::vector<Run> runs;
  for (int i = 0; i < static_cast<int>(border_in_parent.size()); ++i) {
    const int to = border_in_parent[i];
    const bool goes_on = i > 0 && to == border_in_parent[i - 1] + 1 && to != own_of_parent;
    if (!goes_on) runs.push_back({i, to, 0});
    ++runs.back().count;
  }
  return runs;
}

template <class Number>
void Front<Number>::set_size(int own, int border) {
  own_ = own;
  border_ = border;
  inverse_ = {own, own};
  lower_ = {border, own};
  upper_ = {own, border};
}

template <class Number>
std::size_t Front<Number>::vector_size() const {
  return PackedBlock<Number>::padded(own_) + PackedBlock<Number>::padded(border_);
}

template <class Number>
void Front<Number>::place(Work*& vectors, std::byte*& factors) {
  part_ = vectors;
  tail_ = vectors + PackedBlock<Number>::padded(own_);
  vectors += vector_size();
  for (PackedBlock<Number>* block : {&inverse_, &lower_, &upper_}) {
    block->place(factors);
    factors += block->bytes();
  }
}

template <class Number>
void Front<Number>::place_complement(Work*& memory) {
  complement_ = memory;
  memory += complement_size();
}

template <class Number>
void Front<Number>::keep_complement(Work* memory) {
  const Matrix from = complement_in(memory), to = kept_complement();
  for (int j = 0; j < border_; ++j) std::copy(from.column(j), from.column(j) + border_, to.column(j));
}

template <class Number>
void Front<Number>::add_complement(const DenseMatrix<const Work>& complement, const Matrix& parent) const {
  for (const Run& columns : runs)
    for (int j = 0; j < columns.count; ++j) {
      const Work* from = complement.column(columns.from + j);
      Work* column = parent.column(columns.to + j);
      for (const Run& rows : runs)
        for (int i = 0; i < rows.count; ++i) column[rows.to + i] += from[rows.from + i];
    }
}

template <class Number>
void Front<Number>::eliminate(const Matrix& front, Work* beside, Work* scratch) {
  if (own_ == 0) return;
  const Matrix b = front.part(0, own_, own_, border_), c = front.part(own_, 0, border_, own_);
  const Matrix inverse{beside, own_, own_, own_}, upper{beside + std::ptrdiff_t(own_) * own_, own_, border_, own_};
  invert(front.part(0, 0, own_, own_), inverse, scratch);
  inverse_.store(inverse);
  if (border_ == 0) return;
  std::fill(upper.data, upper.data + std::ptrdiff_t(own_) * border_, Work(0));
  add_product(1, inverse, b, upper, scratch);
  upper_.store(upper);
  lower_.store(c);
  add_product(-1, c, upper, front.part(own_, own_, border_, border_), scratch);
}

template <class Number>
void Front<Number>::forward(Work* head, const std::vector<const Front*>& below, Work* scratch) {
  std::fill(tail_, tail_ + PackedBlock<Number>::padded(border_), Work(0));
  for (const Front* child : below)
    for (const Run& run : child->runs) {
      Work* to = run.to < own_ ? head + run.to : tail_ + (run.to - own_);
      for (int i = 0; i < run.count; ++i) to[i] += child->tail_[run.from + i];
    }
  inverse_.multiply(head, part_, scratch);
  lower_.subtract(part_, tail_, scratch);
}

template <class Number>
void Front<Number>::backward(const Work* border, Work* scratch) {
  upper_.subtract(border, part_, scratch);
}

template class Front<float>;
template class Front<double>;
#ifdef SOFTWET_HALF
template class Front<Half>;
#endif

}  // namespace softwet
