// SPDX-License-Identifier: MIT
// An array in a buffer, on the CPU: an index that lies outside of it is an error, and what the frame before left stays until it is overwritten.
#pragma once
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace gno::cpu {

template <class T>
struct CheckedArray : std::vector<T> {
    using std::vector<T>::vector;
    T& operator[](size_t index) {
        if (index >= this->size()) throw std::runtime_error("leaves an array");
        return std::vector<T>::operator[](index);
    }
    [[nodiscard]] size_t length() const { return this->size(); }
    void keep(size_t count, const T& poison) {
        if (this->size() != count) this->assign(count, poison);
    }
};

}  // namespace gno::cpu
