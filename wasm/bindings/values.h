#pragma once

#include <emscripten/val.h>

#include <algorithm>
#include <string>
#include <vector>

/// A view of the module's memory, valid until the next call.
template <typename Array>
emscripten::val lend(const Array& array) {
  return emscripten::val(emscripten::typed_memory_view(array.size(), array.data()));
}

/// The same numbers in memory of JavaScript's.
template <typename Array>
emscripten::val copy(const char* type, const Array& array) {
  return emscripten::val::global(type).new_(lend(array));
}

inline std::vector<double> doubles(const emscripten::val& array) {
  return emscripten::convertJSArrayToNumberVector<double>(array);
}
inline std::vector<int> ints(const emscripten::val& array) {
  return emscripten::convertJSArrayToNumberVector<int>(array);
}

/// The enumerator of that name, or the first: the types of module.ts let no other names through.
template <typename Enum>
Enum named(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  return static_cast<Enum>(found == names.end() ? 0 : found - names.begin());
}
