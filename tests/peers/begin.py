"""How the input of each peer begins, whatever the scene: it reads its particles from pack.data."""

LIGGGHTS_BEGIN = """
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
read_data pack.data"""

LAMMPS_BEGIN = """
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
read_data pack.data"""
