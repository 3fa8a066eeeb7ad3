"""Files of OpenFAST for a small turbine: a tower and two or three equal blades, of ElastoDyn or BeamDyn."""

import blades

NUMBERS = {"NumBl": 3, "TipRad": 22.0, "HubRad": 2.0, "PreCone(1)": -3.0, "PreCone(2)": -3.0, "PreCone(3)": -3.0, "HubCM": 0.5, "OverHang": -4.0, "ShftTilt": -6.0, "NacCMxn": 1.0, "NacCMyn": 0.25,
           "NacCMzn": 1.5, "Twr2Shft": 2.0, "TowerHt": 50.0, "TowerBsHt": 10.0, "TipMass(1)": 0.0, "TipMass(2)": 0.0, "TipMass(3)": 0.0, "HubMass": 900.0, "HubIner": 2000.0, "NacMass": 5000.0,
           "NacYIner": 16000.0, "YawBrMass": 0.0, "PtfmMass": 0.0, "DTTorSpr": 0.0, "DTTorDmp": 0.0, "BlPitch(1)": 0.0, "BlPitch(2)": 0.0, "BlPitch(3)": 0.0, "Azimuth": 0.0, "AzimB1Up": 0.0,
           "RotSpeed": 0.0, "NacYaw": 0.0}
TOWER = [(0.0, 400.0, 4e9, 5e9), (1.0, 200.0, 1e9, 1.25e9)]  # fraction, mass per length, EI fore-aft and side to side


def write_tower(folder, rows=TOWER, factors=(1.0, 1.0, 1.0)):
    names = ("AdjTwMa", "AdjFASt", "AdjSSSt")
    path = folder / "tower.dat"
    path.write_text("------- ELASTODYN V1.00.* TOWER INPUT FILE ---\nA small tower\n" + f"{len(rows)} NTwInpSt - Number of input stations (-)\n" +
                    "".join(f"{factor} {name} - A factor (-)\n" for name, factor in zip(names, factors)) +
                    "--- DISTRIBUTED TOWER PROPERTIES ---\nHtFract TMassDen TwFAStif TwSSStif\n(-) (kg/m) (Nm^2) (Nm^2)\n" + "".join(f"{blades.text_of(row)}\n" for row in rows))
    return path


def write_turbine(folder, **changes):
    """ElastoDyn's primary file, next to tower.dat and the blade file elastodyn.dat; returns its path."""
    numbers = {**NUMBERS, **{key.replace("_1", "(1)").replace("_2", "(2)").replace("_3", "(3)"): value for key, value in changes.items()}}
    write_tower(folder)
    blades.write_elastodyn(folder, blades.SECTIONS, twist=5.0)
    path = folder / "ed_primary.dat"
    path.write_text("------- ELASTODYN v1.03.* INPUT FILE ---\nA small turbine\n" + "".join(f"{value} {key} - A number (-)\n" for key, value in numbers.items()) +
                    "".join(f'"elastodyn.dat" BldFile({i}) - Name of file (quoted string)\n' for i in (1, 2, 3)) + '"tower.dat" TwrFile - Name of file (quoted string)\n')
    return path


def write_fst(folder, beamdyn=None, **changes):
    primary = write_turbine(folder, **changes)
    path = folder / "turbine.fst"
    path.write_text(f'------- OpenFAST INPUT FILE ---\nA small turbine\n{2 if beamdyn else 1} CompElast - Structure (switch) {{1=ElastoDyn}}\n"{primary.name}" EDFile - Name of file (quoted string)\n' +
                    (f'"{beamdyn.name}" BDBldFile(1) - Name of file (quoted string)\n' if beamdyn else ""))
    return path
