#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

namespace dda {

/// The line behind the bytes of every HDF5 file that is written, which HDF5 does not mind:
///
///     "ddapath checksum " and the CRC-32 (ISO 3309) of all bytes before it, eight hexadecimal digits
///
/// A damaged file must not even be opened, since HDF5 may loop for ever in what it takes for its own tables.
std::string seal_of(std::string_view bytes);

/// The same checksum of any bytes: eight hexadecimal digits.
std::string checksum_of(std::string_view bytes);

/// Number of bytes before the seal at the end of a stream, which is left at its beginning. Throws Hdf5Error
/// when there is no seal or it does not fit them.
std::size_t size_before_seal(std::istream& stream);

}  // namespace dda
