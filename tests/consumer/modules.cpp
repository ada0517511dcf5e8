// SPDX-License-Identifier: MIT
// The shader modules as C++, from the installed package.
#include <gnomon/modules.h>

int main() {}
