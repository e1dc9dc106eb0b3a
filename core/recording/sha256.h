#pragma once

namespace vybeg {

// Loads what OpenSSL loads when it is used first, so that a hash can be made beside other work: a
// thread that loads it while another one runs out of memory may end the program.
void prepare_sha256();

}  // namespace vybeg
