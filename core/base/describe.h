#pragma once

#include <concepts>
#include <type_traits>

namespace vybeg {

// The fields of a struct are listed once, in its describe(archive, owner), beside it. An archive
// writes or reads them: archive(name, field), or archive(name, field, usual) for a field that files
// leave out where it has its usual value. Owner: T, or const T for an archive that writes.
template <class Owner, class T>
concept Described = std::same_as<std::remove_const_t<Owner>, T>;

}  // namespace vybeg
