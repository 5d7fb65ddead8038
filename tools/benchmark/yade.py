"""Inputs for Yade (yade-dem.org), and what it answers: a body held by cohesive contacts, with or without shear stiffness."""
import json
import os
import subprocess

PACKAGE = "yade"
PROGRAM = "yade"

SCRIPT = """
import json, time
scene = json.load(open("scene.json"))
elements, bonds = scene["elements"], scene["bonds"]
length = bonds["length"][0]
never = 1e30
O.materials.append(CohFrictMat(young=1e9, poisson=0.2, density=1000, frictionAngle=0.5, isCohesive=True,
                               normalCohesion=never, shearCohesion=never, momentRotationLaw=False))
sheared = bonds["Kt"] > 0
for x, y, mass in zip(elements["x"], elements["y"], elements["mass"]):
    state = O.bodies[O.bodies.append(sphere((x, y, 0), 0.5 * length))].state
    state.mass = mass
    state.inertia = Vector3(1, 1, 1) * 0.125 * mass * length ** 2  # of a disk
    state.blockedDOFs = "zXY" if sheared else "zXYZ"
near = 1.05
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=near, label="bounds")], verletDist=0.05 * length),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=near, label="geometry")],
                    [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True, setCohesionOnNewContacts=False)],
                    [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
    NewtonIntegrator(damping=0)]
O.dt = 1e-30
O.step()
bounds.aabbEnlargeFactor = geometry.interactionDetectionFactor = 1
for bond in O.interactions:
    bond.phys.kn, bond.phys.ks = bonds["Kn"], bonds["Kt"]
for body, vx, vy in zip(O.bodies, elements["vx"], elements["vy"]):
    body.state.vel = (vx, vy, 0)
O.dt = scene["dt"]
seconds = []
for batch in range(scene["batches"]):
    begin = time.perf_counter()
    O.run(scene["steps_per_batch"], True)
    seconds.append((time.perf_counter() - begin) / scene["steps_per_batch"])
O.step()  # forces follow positions one step behind
stored = 0
for bond in O.interactions:
    stored += 0.5 * bond.phys.normalForce.squaredNorm() / bonds["Kn"]
    if sheared:
        stored += 0.5 * bond.phys.shearForce.squaredNorm() / bonds["Kt"]
json.dump({"seconds_per_step": seconds, "stored": stored, "kinetic": utils.kineticEnergy(),
           "bonds": O.interactions.countReal()}, open("answer.json", "w"))
"""


def run(_work, scene, folder):
    (folder / "scene.json").write_text(json.dumps(scene))
    (folder / "in.py").write_text(SCRIPT)
    done = subprocess.run([PROGRAM, "-j1", "-n", "-x", "in.py"], cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    if not (folder / "answer.json").exists():
        raise RuntimeError((done.stdout.strip().splitlines() or ["no answer"])[-1])
    return json.loads((folder / "answer.json").read_text())
