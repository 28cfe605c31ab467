"""The policies and their training."""

import os

# AMX is no faster than AVX-512 here, and in a virtual machine that shares its cores with anything else each switch between
# processes costs it so much that training slows down thirtyfold (docs/performance.md). Read by oneDNN when torch is imported.
os.environ.setdefault("ONEDNN_MAX_CPU_ISA", "AVX512_CORE_BF16")
