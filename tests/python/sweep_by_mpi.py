"""A sweep over the ranks of MPI: mpirun -n 2 python -m mpi4py.futures sweep_by_mpi.py COUNT FILE."""

import sys

import experiments
from mpi4py.futures import MPIPoolExecutor

from passive_haptics.sweep import sweep

if __name__ == "__main__":
    with MPIPoolExecutor() as executor:
        results = sweep(experiments.dies_once, range(int(sys.argv[1])), executor, file=sys.argv[2])
        experiments.print_digest(results)
