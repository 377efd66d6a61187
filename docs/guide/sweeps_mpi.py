"""The experiments of sweeps.py on the ranks of MPI: mpirun -n 2 python -m mpi4py.futures sweeps_mpi.py"""

from mpi4py.futures import MPIPoolExecutor
from sweeps import experiment

from passive_haptics.sweep import sweep

if __name__ == "__main__":
    # MPI
    with MPIPoolExecutor() as executor:  # of mpi4py.futures
        shares = sweep(experiment, range(300), executor, file="mpi.sweep")
    print(f"{sum(shares) / len(shares):.3f}")
