#pragma once

namespace dda {

constexpr double bytes_per_gib = 1024.0 * 1024.0 * 1024.0;

/// Memory that this process may still take [bytes]: what the machine has to spare, within what a container
/// and the shell (ulimit -v) allow.
double usable_memory();

/// Memory that this process holds and does not take again [bytes]: pages of its libraries, and what is
/// allocated; not what it has given back, nor what other allocators have.
double held_memory();

/// What a run may need [bytes]: as set, else `usable_memory`.
double memory_limit();
void set_memory_limit(double bytes);
/// Whether it was set.
bool has_memory_limit();

/// Throws InputError where less address space is left (ulimit -v) than any run needs: without it libraries of
/// linear algebra wait for ever.
void require_address_space();

}  // namespace dda
