# SPDX-License-Identifier: BSD-3-Clause
# Types of the module. tests/python/document_stubs.py writes its docstrings here, where editors read them.
import os
from typing import Any, Dict, Iterable, Iterator, List, Optional, Tuple, Union

import numpy
import numpy.typing

from ._urdf import Urdf

__version__: str

Array = numpy.typing.NDArray[numpy.float64]
Color = Tuple[Optional[float], Optional[float], Optional[float], Optional[float]]
Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]
Texts = Union[str, Iterable[str]]
Paths = Union[Path, Iterable[Path]]
Positions = Union[str, Dict[str, Any], numpy.typing.ArrayLike]
Argument = Union[str, int, float]
Geometry = Union["Box", "Sphere", "Cylinder", "Capsule", "Mesh"]
Attachment = Union[str, Tuple[str, str]]

class Place:
    """A range of a file: lines and columns (characters) from 1; the end is exclusive."""
    @property
    def file(self) -> str:
        """The path, as it was given or found."""
    @property
    def line(self) -> int:
        """First line."""
    @property
    def column(self) -> int:
        """First column, in characters."""
    @property
    def end_line(self) -> int:
        """Line of the end."""
    @property
    def end_column(self) -> int:
        """Column of the end."""
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...

class Finding:
    """One fault at one place, as smurf-lint reports it."""
    @property
    def id(self) -> str:
        """Id of the rule: "SML3101"."""
    @property
    def name(self) -> str:
        """Name of the rule: "unknown-joint"."""
    @property
    def severity(self) -> str:
        """"error", "warning" or "info"."""
    @property
    def message(self) -> str:
        """What is wrong, in one sentence."""
    @property
    def help(self) -> str:
        """What to do about it; may be empty."""
    @property
    def notes(self) -> List[str]:
        """Facts without a place."""
    @property
    def pointer(self) -> str:
        """YAML pointer or XPath of the place."""
    @property
    def place(self) -> Place:
        """The characters at fault."""
    @property
    def labels(self) -> List[Tuple[Place, str]]:
        """Other places that explain it: tuples of a smurf.Place and a text."""
    @property
    def fix(self) -> Optional[Dict[str, Any]]:
        """None, or a dict: `is_safe`, and `edits` with `file`, `begin` and `end` (bytes) and `text`, as in the
        JSON report.
        """
    def text(self) -> str:
        """With the lines of the file, as smurf-lint shows it."""

class TargetVerdict:
    """What one reader does with the files."""
    @property
    def target(self) -> str:
        """Name of the reader: "mujoco"."""
    @property
    def answer(self) -> str:
        """"takes", "loses", "unknown" or "refuses"."""
    @property
    def refusals(self) -> int:
        """Findings for which it refuses the files."""
    @property
    def losses(self) -> int:
        """Findings that it silently reads differently."""
    @property
    def unknown(self) -> int:
        """Errors whose effect on it is not known."""

class Report:
    """What a check has found; a sequence of findings."""
    @property
    def findings(self) -> List[Finding]:
        """A new list of smurf.Finding, sorted by file, line, column and id."""
    @property
    def errors(self) -> int:
        """Number of findings that are errors."""
    @property
    def warnings(self) -> int:
        """Number of findings that are warnings."""
    @property
    def infos(self) -> int:
        """Number of findings that are infos."""
    @property
    def suppressed(self) -> int:
        """Number of findings that comments or the baseline suppress."""
    @property
    def targets(self) -> List[TargetVerdict]:
        """A list of smurf.TargetVerdict, one for each target."""
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Finding]: ...
    def __getitem__(self, index: int) -> Finding: ...
    def to_json(self) -> str:
        """The report as JSON text (schemas/lint-report.schema.json)."""
    def text(self) -> str:
        """As smurf-lint shows it."""
    def fixed(self, unsafe: bool = ..., infos: bool = ...) -> Dict[str, bytes]:
        """The files with the safe fixes, or with all fixes, of errors and warnings, and of infos if they are asked
        for: a dict from paths to bytes. Fixes that overlap others are left for another round; smurf.fix() makes
        all rounds.
        """

# What references to parts of a file have; no class of this name exists.
class _Reference:
    @property
    def places(self) -> Dict[str, Place]: ...
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...

class _Part(_Reference):
    @property
    def place(self) -> Place: ...

class _Named(_Part):
    @property
    def name(self) -> Optional[str]: ...

class _Annotation(_Named): ...

class Box(_Reference):
    """A box around the origin."""
    @property
    def size(self) -> Optional[Array]:
        """Full lengths of the edges along x, y and z, m. As written: array of shape (3,)."""

class Sphere(_Reference):
    """A sphere around the origin."""
    @property
    def radius(self) -> Optional[float]:
        """Radius, m."""

class Cylinder(_Reference):
    """A cylinder around the origin, its axis along z."""
    @property
    def radius(self) -> Optional[float]:
        """Radius, m."""
    @property
    def length(self) -> Optional[float]:
        """Length along z, m."""

class Capsule(_Reference):
    """A cylinder with half spheres at its ends, its axis along z; read since version 1.1 of URDF."""
    @property
    def radius(self) -> Optional[float]:
        """Radius, m."""
    @property
    def length(self) -> Optional[float]:
        """Length along z, without the half spheres, m."""

class Mesh(_Reference):
    """The triangles of a mesh file."""
    @property
    def filename(self) -> Optional[str]:
        """The mesh: a path, or package://NAME/PATH."""
    @property
    def scale(self) -> Optional[Array]:
        """Factors along x, y and z; None means 1 1 1. As written: array of shape (3,)."""
    @property
    def path(self) -> Optional[str]:
        """Where the file is, as URDF readers look for it; None when it is unknown."""
    @property
    def exists(self) -> bool:
        """Whether there is a file."""

class Material(_Named):
    """A colour or a texture, with a name that visuals share."""
    @property
    def rgba(self) -> Optional[Tuple[float, float, float, float]]:
        """Red, green, blue and alpha, each from 0 to 1."""
    @property
    def texture(self) -> Optional[str]:
        """The image: a path, or package://NAME/PATH."""

class Inertial(_Part):
    """Mass, centre of mass and inertia of the link."""
    @property
    def mass(self) -> Optional[float]:
        """Mass of the link, kg."""
    @property
    def X_LI(self) -> Array:
        """Pose of the inertial frame I, whose origin is the centre of mass, in the link: array of shape (4, 4), m.
        """
    @property
    def inertia(self) -> Optional[Array]:
        """About the centre of mass, in the inertial frame: array of shape (3, 3), kg m^2. None when one of the six
        numbers is missing.
        """

class Visual(_Named):
    """The appearance of the link."""
    @property
    def X_LV(self) -> Array:
        """Pose in the link: array of shape (4, 4), m."""
    @property
    def geometry(self) -> Optional[Geometry]:
        """smurf.Box, Sphere, Cylinder, Capsule or Mesh; None when there is none."""
    @property
    def material(self) -> Optional[Material]:
        """smurf.Material or None."""

class Collision(_Named):
    """The shape of the link for collision detection."""
    @property
    def X_LC(self) -> Array:
        """Pose in the link: array of shape (4, 4), m."""
    @property
    def geometry(self) -> Optional[Geometry]:
        """smurf.Box, Sphere, Cylinder, Capsule or Mesh; None when there is none."""

class Link(_Named):
    """A rigid body."""
    @property
    def inertial(self) -> Optional[Inertial]:
        """smurf.Inertial or None."""
    @property
    def visuals(self) -> List[Visual]:
        """A new list of smurf.Visual."""
    @property
    def collisions(self) -> List[Collision]:
        """A new list of smurf.Collision."""

class Limit(_Part):
    """Limits of the joint; revolute and prismatic joints need them."""
    @property
    def lower(self) -> Optional[float]:
        """Lowest position, rad or m; None means 0."""
    @property
    def upper(self) -> Optional[float]:
        """Highest position, rad or m; None means 0."""
    @property
    def effort(self) -> Optional[float]:
        """Largest torque or force, N m or N."""
    @property
    def velocity(self) -> Optional[float]:
        """Largest speed, rad/s or m/s."""

class Dynamics(_Part):
    """Damping and friction of the joint."""
    @property
    def damping(self) -> Optional[float]:
        """Viscous damping, N m s/rad or N s/m; None means 0."""
    @property
    def friction(self) -> Optional[float]:
        """Static friction, N m or N; None means 0."""

class Mimic(_Part):
    """The joint follows another one."""
    @property
    def joint(self) -> Optional[str]:
        """Joint that this one follows."""
    @property
    def multiplier(self) -> Optional[float]:
        """Factor on the position of that joint; None means 1."""
    @property
    def offset(self) -> Optional[float]:
        """Offset that is added to the result, rad or m; None means 0."""

class SafetyController(_Part):
    """Limits of the controller within those of the joint."""
    @property
    def soft_lower_limit(self) -> Optional[float]:
        """Where the controller begins to limit the position, rad or m; None means 0."""
    @property
    def soft_upper_limit(self) -> Optional[float]:
        """Where the controller begins to limit the position, rad or m; None means 0."""
    @property
    def k_position(self) -> Optional[float]:
        """Relation between position and velocity limits; None means 0."""
    @property
    def k_velocity(self) -> Optional[float]:
        """Relation between effort and velocity limits."""

class Calibration(_Part):
    """Where the joint is calibrated."""
    @property
    def rising(self) -> Optional[float]:
        """Position at which the reference rises, rad or m."""
    @property
    def falling(self) -> Optional[float]:
        """Position at which the reference falls, rad or m."""

class Joint(_Named):
    """How a child link moves relative to its parent link."""
    @property
    def type(self) -> str:
        """"revolute", "continuous", "prismatic", "fixed", "floating", "planar" or "unknown"."""
    @property
    def parent(self) -> Optional[str]:
        """Name of the parent link."""
    @property
    def child(self) -> Optional[str]:
        """Name of the child link."""
    @property
    def axis(self) -> Optional[Array]:
        """Direction in the joint's frame, of length 1; None means 1 0 0. As written: array of shape (3,)."""
    @property
    def X_PJ(self) -> Array:
        """Pose of the joint's frame, which is that of the child link at position zero, in the parent link: array
        of shape (4, 4), m.
        """
    @property
    def limit(self) -> Optional[Limit]:
        """smurf.Limit or None."""
    @property
    def dynamics(self) -> Optional[Dynamics]:
        """smurf.Dynamics or None."""
    @property
    def mimic(self) -> Optional[Mimic]:
        """smurf.Mimic or None."""
    @property
    def safety_controller(self) -> Optional[SafetyController]:
        """smurf.SafetyController or None."""
    @property
    def calibration(self) -> Optional[Calibration]:
        """smurf.Calibration or None."""
    @property
    def is_movable(self) -> bool:
        """True for a joint that can move."""

class Motor(_Annotation):
    """An entry of `motors`."""
    @property
    def joint(self) -> Optional[str]:
        """Joint that it drives."""
    @property
    def type(self) -> Optional[str]:
        """"PID", "DC", ..."""
    @property
    def max_speed(self) -> Optional[float]:
        """rad/s or m/s."""
    @property
    def max_effort(self) -> Optional[float]:
        """N m or N."""
    @property
    def min_value(self) -> Optional[float]:
        """Lowest commanded position, rad or m."""
    @property
    def max_value(self) -> Optional[float]:
        """Highest commanded position, rad or m."""
    @property
    def min_position(self) -> Optional[float]:
        """Newer name of min_value; MARS prefers it."""
    @property
    def max_position(self) -> Optional[float]:
        """Newer name of max_value; MARS prefers it."""
    @property
    def p(self) -> Optional[float]:
        """Proportional gain."""
    @property
    def i(self) -> Optional[float]:
        """Integral gain; MARS measures time in milliseconds."""
    @property
    def d(self) -> Optional[float]:
        """Differential gain; MARS measures time in milliseconds."""
    @property
    def mimic_motor(self) -> Optional[str]:
        """Motor that it follows."""
    @property
    def mimic_multiplier(self) -> Optional[float]:
        """Factor on the leader's position."""
    @property
    def mimic_offset(self) -> Optional[float]:
        """Added to that, rad or m."""

class Sensor(_Annotation):
    """An entry of `sensors`."""
    @property
    def type(self) -> Optional[str]:
        """"JointPosition", "CameraSensor", ..."""
    @property
    def link(self) -> Optional[str]:
        """Link that it is on."""
    @property
    def joint(self) -> Optional[str]:
        """Joint that it is on."""
    @property
    def id(self) -> Optional[List[str]]:
        """What it measures: names of links, joints, motors or collisions."""
    @property
    def links(self) -> Optional[List[str]]:
        """Links that it measures."""
    @property
    def joints(self) -> Optional[List[str]]:
        """Joints that it measures."""
    @property
    def motors(self) -> Optional[List[str]]:
        """Motors that it measures."""
    @property
    def collisions(self) -> Optional[List[str]]:
        """Collisions that it measures."""
    @property
    def rate(self) -> Optional[float]:
        """How often it measures, as the file has it."""

class Controller(_Annotation):
    """An entry of `controllers`."""
    @property
    def sensors(self) -> Optional[List[str]]:
        """Sensors that it reads."""
    @property
    def motors(self) -> Optional[List[str]]:
        """Motors that it commands."""
    @property
    def rate(self) -> Optional[float]:
        """How often it runs, as the file has it."""
    @property
    def dylib_path(self) -> Optional[str]:
        """Library with its code."""

class MaterialAnnotation(_Annotation):
    """An entry of `materials`."""
    @property
    def ambient_color(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def diffuse_color(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def specular_color(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def emission_color(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def shininess(self) -> Optional[float]:
        """Exponent of the highlight."""
    @property
    def transparency(self) -> Optional[float]:
        """0 to 1."""
    @property
    def diffuse_texture(self) -> Optional[str]:
        """Image file."""
    @property
    def normal_texture(self) -> Optional[str]:
        """Image file."""
    @property
    def displacement_texture(self) -> Optional[str]:
        """Image file."""

class CollisionAnnotation(_Annotation):
    """An entry of `collision`."""
    @property
    def link(self) -> Optional[str]:
        """Link of the collision."""
    @property
    def bitmask(self) -> Optional[int]:
        """Two shapes touch when their masks share a bit."""

class VisualAnnotation(_Annotation):
    """An entry of `visuals`."""
    @property
    def link(self) -> Optional[str]:
        """Link of the visual."""
    @property
    def material_name(self) -> Optional[str]:
        """Material."""

class LinkAnnotation(_Annotation):
    """An entry of `link`."""
    @property
    def link(self) -> Optional[str]:
        """The link, for MARS 2."""

class NodeAnnotation(_Annotation):
    """An entry of `nodes`."""
    @property
    def parent(self) -> Optional[str]:
        """Node above."""
    @property
    def viz_link(self) -> Optional[str]:
        """Link."""
    @property
    def material_name(self) -> Optional[str]:
        """Material."""

class JointAnnotation(_Annotation):
    """An entry of `joint`."""
    @property
    def type(self) -> Optional[str]:
        """Type, for MARS."""
    @property
    def parent(self) -> Optional[str]:
        """Parent link."""
    @property
    def child(self) -> Optional[str]:
        """Child link."""
    @property
    def low_stop(self) -> Optional[float]:
        """Lower stop of axis 1, rad or m."""
    @property
    def high_stop(self) -> Optional[float]:
        """Upper stop of axis 1, rad or m."""
    @property
    def axis(self) -> Optional[Array]:
        """Array of shape (3,)."""

class JointTask(_Annotation):
    """An entry of `joint_tasks`; `name` is the joint."""
    @property
    def provider(self) -> Optional[str]:
        """Task that provides the pose of the child link."""
    @property
    def port(self) -> Optional[str]:
        """Port of that task."""
    @property
    def driver(self) -> Optional[str]:
        """Task that drives the joint."""

class JointPoseSet(_Annotation):
    """An entry of `poses`: named joint positions."""
    @property
    def positions(self) -> Dict[str, float]:
        """A dict from motors or joints, as written, to positions, rad or m. Model.joint_positions() names joints
        only.
        """

class Submechanism(_Annotation):
    """An entry of `submechanisms`."""
    @property
    def contextual_name(self) -> Optional[str]:
        """Name of this mechanism in the robot."""
    @property
    def type(self) -> Optional[str]:
        """Type."""
    @property
    def joint_names(self) -> Optional[List[str]]:
        """All joints."""
    @property
    def joint_names_spanning_tree(self) -> Optional[List[str]]:
        """Joints."""
    @property
    def joint_names_active(self) -> Optional[List[str]]:
        """Joints."""
    @property
    def joint_names_independent(self) -> Optional[List[str]]:
        """Joints."""

class Exoskeleton(_Annotation):
    """An entry of `exoskeletons`."""
    @property
    def contextual_name(self) -> Optional[str]:
        """Name of this mechanism in the robot."""
    @property
    def around(self) -> Optional[str]:
        """Part of the human."""
    @property
    def joint_names(self) -> Optional[List[str]]:
        """All joints."""
    @property
    def joint_names_spanning_tree(self) -> Optional[List[str]]:
        """Joints."""
    @property
    def joint_names_dependent(self) -> Optional[List[str]]:
        """Joints."""

class Interface(_Annotation):
    """An entry of `interfaces`."""
    @property
    def parent(self) -> Optional[str]:
        """Link."""
    @property
    def type(self) -> Optional[str]:
        """Type."""
    @property
    def direction(self) -> Optional[str]:
        """Direction."""
    @property
    def position(self) -> Optional[Array]:
        """In the parent link: array of shape (3,), m."""
    @property
    def rotation(self) -> Optional[Array]:
        """In the parent link: roll, pitch, yaw about its fixed axes, array of shape (3,), rad."""

class Submodel(_Annotation):
    """An entry of `submodels`."""
    @property
    def export_directory(self) -> Optional[str]:
        """Folder."""
    @property
    def start(self) -> Optional[str]:
        """Root link."""
    @property
    def stop(self) -> Optional[List[str]]:
        """Links at which it ends."""

class Light(_Annotation):
    """An entry of `lights`, in the world."""
    @property
    def position(self) -> Optional[Array]:
        """Array of shape (3,), m."""
    @property
    def look_at(self) -> Optional[Array]:
        """Array of shape (3,), m."""
    @property
    def ambient(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def diffuse(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def specular(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def type(self) -> Optional[int]:
        """1 omni, 2 spot."""
    @property
    def angle(self) -> Optional[float]:
        """Of a spot, as the file has it."""
    @property
    def exponent(self) -> Optional[float]:
        """Of a spot."""
    @property
    def constant_attenuation(self) -> Optional[float]:
        """Attenuation."""
    @property
    def linear_attenuation(self) -> Optional[float]:
        """Attenuation."""
    @property
    def quadratic_attenuation(self) -> Optional[float]:
        """Attenuation."""
    @property
    def directional(self) -> Optional[bool]:
        """Whether it shines from far away."""
    @property
    def node_name(self) -> Optional[str]:
        """Node that it is on."""

class Graphics(_Annotation):
    """What `graphics` holds."""
    @property
    def clear_color(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def fog_color(self) -> Optional[Color]:
        """r, g, b, a; each 0 to 1 or None."""
    @property
    def fog_enabled(self) -> Optional[bool]:
        """Whether there is fog."""
    @property
    def fog_density(self) -> Optional[float]:
        """Density."""
    @property
    def fog_start(self) -> Optional[float]:
        """m."""
    @property
    def fog_end(self) -> Optional[float]:
        """m."""
class Model:
    """A model: a .smurf with its URDF and annotations, or a URDF."""
    @property
    def path(self) -> str:
        """The path it was loaded by."""
    @property
    def name(self) -> Optional[str]:
        """`modelname` of the .smurf, else the name of the robot; None when there is neither."""
    @property
    def files(self) -> List[str]:
        """The paths of all files that were read, meshes left out, in their order."""
    @property
    def urdf_path(self) -> Optional[str]:
        """The path of the URDF; None when there is none."""
    @property
    def is_complete(self) -> bool:
        """False when a file is missing or broken."""
    @property
    def links(self) -> List[Link]:
        """A new list of smurf.Link, in the order of the URDF."""
    @property
    def joints(self) -> List[Joint]:
        """A new list of smurf.Joint, in the order of the URDF."""
    @property
    def materials(self) -> List[Material]:
        """A new list of smurf.Material: those of the robot."""
    @property
    def roots(self) -> List[Link]:
        """A new list of the links without a parent joint; poses are those in the first one."""
    @property
    def motors(self) -> List[Motor]:
        """A new list of smurf.Motor."""
    @property
    def sensors(self) -> List[Sensor]:
        """A new list of smurf.Sensor."""
    @property
    def controllers(self) -> List[Controller]:
        """A new list of smurf.Controller."""
    @property
    def material_annotations(self) -> List[MaterialAnnotation]:
        """A new list of smurf.MaterialAnnotation."""
    @property
    def collision_annotations(self) -> List[CollisionAnnotation]:
        """A new list of smurf.CollisionAnnotation."""
    @property
    def visual_annotations(self) -> List[VisualAnnotation]:
        """A new list of smurf.VisualAnnotation."""
    @property
    def link_annotations(self) -> List[LinkAnnotation]:
        """A new list of smurf.LinkAnnotation."""
    @property
    def node_annotations(self) -> List[NodeAnnotation]:
        """A new list of smurf.NodeAnnotation."""
    @property
    def joint_annotations(self) -> List[JointAnnotation]:
        """A new list of smurf.JointAnnotation."""
    @property
    def joint_tasks(self) -> List[JointTask]:
        """A new list of smurf.JointTask."""
    @property
    def lights(self) -> List[Light]:
        """A new list of smurf.Light."""
    @property
    def graphics(self) -> List[Graphics]:
        """A new list of smurf.Graphics."""
    @property
    def poses(self) -> List[JointPoseSet]:
        """A new list of smurf.JointPoseSet."""
    @property
    def submechanisms(self) -> List[Submechanism]:
        """A new list of smurf.Submechanism."""
    @property
    def exoskeletons(self) -> List[Exoskeleton]:
        """A new list of smurf.Exoskeleton."""
    @property
    def interfaces(self) -> List[Interface]:
        """A new list of smurf.Interface."""
    @property
    def submodels(self) -> List[Submodel]:
        """A new list of smurf.Submodel."""
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def link(self, name: str) -> Link:
        """The link of a name; KeyError when there is none."""
    def joint(self, name: str) -> Joint:
        """The joint of a name; KeyError when there is none."""
    @property
    def free_joints(self) -> List[Joint]:
        """A new list of smurf.Joint: those with one axis that mimic no other joint, in the order of the URDF. They
        are the columns of arrays of positions.
        """
    def forward_kinematics(
        self, positions: Optional[Positions] = ..., joints: Optional[Texts] = ...
    ) -> Dict[str, Array]:
        """The poses of the links: a dict from names of links to X_RL, the pose of the link L in the first root
        link R, an array of shape (4, 4), m.

        `positions` is a dict from names of joints to rad or m, the name of a joint pose set, or an array of
        shape (joints,) with a number for each of `free_joints`, or for each of the names in `joints`. Joints
        that it leaves out are at zero, and those that mimic others follow them. Arrays of shape (n, joints), or
        arrays of shape (n,) in the dict, are n configurations: the results have the shape (n, 4, 4). Links that
        the root does not reach are left out.
        """
    def joint_positions(self, pose: str) -> Dict[str, float]:
        """The positions of a joint pose set by joints: a dict, rad or m."""
    def joint_order(self, reader: str) -> Dict[str, Any]:
        """The order in which a reader such as "mujoco" or "pinocchio" builds the robot, a dict: `joints`, the
        names of the joints with positions in the order of the positions; `indices`, an array of their indices
        in functions of the reader; `bodies`, their names; `walk` and `basis`, the order in words, and the
        versions that were executed. Raises ValueError if the order is not known.
        """
    def joint_permutation(self, source: str, target: str) -> numpy.typing.NDArray[numpy.int64]:
        """An array of integers p: positions q in the order of the reader `source` are q[p] in that of `target`.
        Raises ValueError if an order is not known, or if `source` lacks a joint that `target` has.
        """
    def check(self) -> Report:
        """Checks the model as it was loaded, and returns a smurf.Report."""
    def to_urdf(
        self, *, output_folder: Path = ..., mesh_uri: str = ..., apply: Texts = ..., prefix: str = ...,
        base: str = ..., keep: Texts = ..., collapse_fixed: bool = ..., strip_comments: bool = ...,
        strip_extensions: bool = ..., canonical: bool = ..., force: bool = ...
    ) -> Urdf:
        """The plain URDF as bytes with `losses`, a smurf.Urdf, as smurf2urdf writes it: the model's own, with mesh
        paths that resolve from `output_folder`, and what the options ask for. It is read again and compared
        with the model. Raises smurf.Error for errors that make it wrong, unless `force`; nothing is written.
        """
    def to_json(self) -> str:
        """Everything that was read, as JSON text (schemas/model-dump.schema.json)."""
    def write(
        self, format: str, *, output_folder: Path = ..., dialect: str = ..., form: Optional[str] = ...,
        base: Optional[str] = ..., ground: bool = ..., links: bool = ..., force: bool = ...
    ) -> Export:
        """The text of a format of smurfs-flatten (`mjcf`, `sdf`, `urdf`, `usda`, `gltf`, `html`, ...), as a
        smurf.Export. Paths in it start at `output_folder`. `form` is "expand" or "reference", `base` "fixed" or
        "floating" for models that are anchored nowhere; `ground` adds a floor, `links` the poses of all links.
        Raises smurf.Error for errors that leave a pose unknown, and, unless `force`, for others that make the
        result wrong.
        """

class Instance:
    """An entity of a scene, nested scenes expanded."""
    @property
    def name(self) -> str:
        """As it is written; may repeat, and may be empty."""
    @property
    def path(self) -> str:
        """Unique: "outer/inner"."""
    @property
    def type(self) -> str:
        """As written, else the extension of the file."""
    @property
    def file(self) -> Optional[str]:
        """The path of its file; None when there is none."""
    @property
    def model(self) -> Optional[Model]:
        """smurf.Model, or None."""
    @property
    def X_WE(self) -> Optional[Array]:
        """Pose of its root link in the world: array of shape (4, 4), m. None when that is not known because of an
        error.
        """
    @property
    def parent(self) -> Attachment:
        """"world", or a tuple of the path of an instance and the name of its link."""
    @property
    def anchor(self) -> Attachment:
        """What it is fixed to: "none", "world", or as for `parent`."""
    @property
    def joint_positions(self) -> Dict[str, float]:
        """Those of its joint pose set: a dict from joints to rad or m."""
    @property
    def place(self) -> Place:
        """Where it is written."""
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...

class FlatInstance:
    """An instance with its pose in the world."""
    @property
    def name(self) -> str:
        """As it is written."""
    @property
    def path(self) -> str:
        """Unique: "outer/inner"."""
    @property
    def type(self) -> str:
        """Type."""
    @property
    def model(self) -> Optional[str]:
        """Id of its model in FlatScene.models; None when it has none."""
    @property
    def source(self) -> Tuple[str, int]:
        """File and line of the entity."""
    @property
    def X_WE(self) -> Optional[Array]:
        """Pose of the root link in the world: array of shape (4, 4), m. None when the dialect does not load the
        entity.
        """
    @property
    def position(self) -> Optional[Array]:
        """In the world: array of shape (3,), m."""
    @property
    def orientation(self) -> Optional[Array]:
        """In the world: unit quaternion (w, x, y, z), array of shape (4,), w >= 0."""
    @property
    def parent(self) -> Attachment:
        """"world", or a tuple of the path of an instance and the name of its link."""
    @property
    def anchor(self) -> Attachment:
        """What it is fixed to: "none", "world", or as for `parent`."""
    @property
    def joint_positions(self) -> Dict[str, float]:
        """A dict from joints to rad or m."""
    @property
    def properties(self) -> Dict[str, Any]:
        """Every key of the entity that has no attribute, as a dict."""
    @property
    def links(self) -> Dict[str, Array]:
        """With flatten(links=True): a dict from links to X_WL, the pose in the world, arrays of shape (4, 4), m.
        """

class FlatModel:
    """A model of a flat scene."""
    @property
    def id(self) -> str:
        """Unique in the scene."""
    @property
    def type(self) -> str:
        """"smurf" or "urdf"."""
    @property
    def file(self) -> str:
        """Path from the output folder."""
    @property
    def urdf(self) -> str:
        """Path of its URDF from the output folder; may be empty."""

class Export:
    """A model or scene as the text of a format."""
    @property
    def format(self) -> str:
        """Name of the format: "mjcf"."""
    @property
    def text(self) -> str:
        """What the file contains."""
    @property
    def losses(self) -> List[Finding]:
        """A new list of smurf.Finding: what the format cannot express."""
    def save(self, path: Path) -> None:
        """Writes the text into a file, which is replaced as a whole."""

class Comparison:
    """What differs between two versions of a robot."""
    @property
    def differences(self) -> List[Dict[str, Any]]:
        """A new list of dicts, as in the JSON report (schemas/diff-report.schema.json)."""
    def text(self) -> str:
        """As smurf-diff shows it."""
    def to_json(self) -> str:
        """The report as JSON text (schemas/diff-report.schema.json)."""
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Dict[str, Any]]: ...

class FlatScene:
    """A scene as a table of instances in the world; what smurfs-flatten writes."""
    @property
    def models(self) -> List[FlatModel]:
        """A new list of smurf.FlatModel, each once."""
    @property
    def instances(self) -> List[FlatInstance]:
        """A new list of smurf.FlatInstance, in the order of the scene."""
    @property
    def X_WE(self) -> Array:
        """Poses of all n instances in the world: array of shape (n, 4, 4), m. NaN where a dialect does not load
        one.
        """
    @property
    def positions(self) -> Array:
        """Array of shape (n, 3), m, in the world."""
    @property
    def orientations(self) -> Array:
        """Unit quaternions (w, x, y, z): array of shape (n, 4)."""
    @property
    def gravity(self) -> Optional[Array]:
        """Array of shape (3,), m/s^2; None when the scene does not say it."""
    def __len__(self) -> int: ...
    def to_json(self) -> str:
        """As smurfs-flatten writes it (schemas/flat-scene.schema.json)."""

class Scene:
    """A scene with all scenes and models in it."""
    @property
    def path(self) -> str:
        """The path it was loaded by."""
    @property
    def files(self) -> List[str]:
        """The scene files, the loaded one first."""
    @property
    def is_complete(self) -> bool:
        """False when a file is missing or broken."""
    @property
    def instances(self) -> List[Instance]:
        """A new list of smurf.Instance, depth-first, in the order of the files."""
    @property
    def models(self) -> List[Model]:
        """A new list of smurf.Model, each file once."""
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...
    def instance(self, name: str) -> Instance:
        """An instance by its path, else the first by its name; or KeyError."""
    def check(self) -> Report:
        """Checks the scene as it was loaded, and returns a smurf.Report."""
    def flatten(
        self, *, dialect: str = ..., links: bool = ..., output_folder: Path = ..., force: bool = ...
    ) -> FlatScene:
        """The scene as a smurf.FlatScene, as smurfs-flatten has it. `links` adds the poses of all links, `dialect`
        places entities as MARS or Phobos does. Raises smurf.Error for a scene with errors; `force` ignores
        those that leave every pose known.
        """
    def to_json(self) -> str:
        """Everything that was read, as JSON text (schemas/model-dump.schema.json)."""
    def write(
        self, format: str, *, output_folder: Path = ..., dialect: str = ..., form: Optional[str] = ...,
        base: Optional[str] = ..., ground: bool = ..., links: bool = ..., force: bool = ...
    ) -> Export:
        """The text of a format of smurfs-flatten (`mjcf`, `sdf`, `urdf`, `usda`, `gltf`, `html`, ...), as a
        smurf.Export. Paths in it start at `output_folder`. `form` is "expand" or "reference", `base` "fixed" or
        "floating" for models that are anchored nowhere; `ground` adds a floor, `links` the poses of all links.
        Raises smurf.Error for errors that leave a pose unknown, and, unless `force`, for others that make the
        result wrong.
        """

class Session:
    """Files on the disk with unsaved texts in front of them, for editors: a second check reads again only what has
    changed.
    """
    def __init__(self) -> None: ...
    def set_text(self, path: Path, text: Union[str, bytes]) -> None:
        """Puts a str or bytes in the place of a file."""
    def clear_text(self, path: Path) -> None:
        """What is on the disk counts again."""
    def check(
        self, path: Paths, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
        select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
        severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
        packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
        xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
        no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ...,
        max_seconds: Optional[int] = ..., jobs: Optional[int] = ...
    ) -> Report:
        """Checks a model, URDF, xacro, scene or annotation file with all that it loads, or all such files in a
        folder, or an iterable of files and folders, and returns a smurf.Report. Raises smurf.Error when a path
        cannot be read.

        Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
        `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
        "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
        dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read),
        `baseline` (a path), `no_ignores`, `allow_outside` (read what models name wherever it lies),
        `max_seconds` (of processor time for each file; 0: no end), `jobs`.
        """
    def load_model(
        self, path: Path, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
        select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
        severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
        packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
        xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
        no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ...,
        max_seconds: Optional[int] = ..., jobs: Optional[int] = ...
    ) -> Model:
        """Loads a .smurf, a .urdf, a .xacro, an annotation file or an archive (.zsmurf), and returns a
        smurf.Model. What is wrong in it is told by its check(); smurf.Error is raised when there is nothing
        that could be read.

        Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
        `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
        "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
        dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read),
        `baseline` (a path), `no_ignores`, `allow_outside` (read what models name wherever it lies),
        `max_seconds` (of processor time for each file; 0: no end), `jobs`.
        """
    def load_scene(
        self, path: Path, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
        select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
        severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
        packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
        xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
        no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ...,
        max_seconds: Optional[int] = ..., jobs: Optional[int] = ...
    ) -> Scene:
        """Loads a .smurfs, a .smurfa, a drawing (.svg) or an archive with all models and scenes it names, and
        returns a smurf.Scene; a .smurf or .urdf counts as a scene of one entity. Raises smurf.Error as
        load_model() does.

        Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
        `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
        "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
        dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read),
        `baseline` (a path), `no_ignores`, `allow_outside` (read what models name wherever it lies),
        `max_seconds` (of processor time for each file; 0: no end), `jobs`.
        """

def check(
    path: Paths, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
    select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
    severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
    packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
    xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
    no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ..., max_seconds: Optional[int] = ...,
    jobs: Optional[int] = ...
) -> Report:
    """Checks a model, URDF, xacro, scene or annotation file with all that it loads, or all such files in a folder,
    or an iterable of files and folders, and returns a smurf.Report. Raises smurf.Error when a path cannot be
    read.

    Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
    `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
    "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
    dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read), `baseline` (a
    path), `no_ignores`, `allow_outside` (read what models name wherever it lies), `max_seconds` (of processor
    time for each file; 0: no end), `jobs`.
    """
def load_model(
    path: Path, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
    select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
    severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
    packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
    xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
    no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ..., max_seconds: Optional[int] = ...,
    jobs: Optional[int] = ...
) -> Model:
    """Loads a .smurf, a .urdf, a .xacro, an annotation file or an archive (.zsmurf), and returns a smurf.Model.
    What is wrong in it is told by its check(); smurf.Error is raised when there is nothing that could be read.

    Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
    `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
    "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
    dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read), `baseline` (a
    path), `no_ignores`, `allow_outside` (read what models name wherever it lies), `max_seconds` (of processor
    time for each file; 0: no end), `jobs`.
    """
def load_scene(
    path: Path, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
    select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
    severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
    packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
    xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
    no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ..., max_seconds: Optional[int] = ...,
    jobs: Optional[int] = ...
) -> Scene:
    """Loads a .smurfs, a .smurfa, a drawing (.svg) or an archive with all models and scenes it names, and returns
    a smurf.Scene; a .smurf or .urdf counts as a scene of one entity. Raises smurf.Error as load_model() does.

    Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
    `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
    "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
    dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read), `baseline` (a
    path), `no_ignores`, `allow_outside` (read what models name wherever it lies), `max_seconds` (of processor
    time for each file; 0: no end), `jobs`.
    """
def parse_urdf(
    text: Union[str, bytes], filename: Optional[Path] = ..., *, config: Optional[Path] = ...,
    isolated: Optional[bool] = ..., select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
    severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
    packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
    xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
    no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ..., max_seconds: Optional[int] = ...,
    jobs: Optional[int] = ...
) -> Model:
    """Loads the text of a URDF (str or bytes) and returns a smurf.Model; the text of a xacro file is expanded.
    Relative paths in it start at the folder of `filename`, or at the current folder.

    Keyword arguments, as the options of smurf-lint: `config` (a path), `isolated` (read no configuration),
    `select` and `ignore` (ids, names or prefixes of rules), `severities` (a dict from rules to "error",
    "warning" or "info"), `targets` (names of readers), `packages` (a dict from names to folders), `args` (a
    dict with the arguments of a .xacro), `xacro_env` (names of variables that a .xacro may read), `baseline` (a
    path), `no_ignores`, `allow_outside` (read what models name wherever it lies), `max_seconds` (of processor
    time for each file; 0: no end), `jobs`.
    """
def diff(
    before: Path, after: Path, tolerance: float = ..., *, packages: Optional[Dict[str, Path]] = ...,
    args: Optional[Dict[str, Argument]] = ..., xacro_env: Optional[Texts] = ...
) -> Comparison:
    """Compares two versions of a model, URDF, xacro file or scene by what they mean for the robot, as smurf-diff
    does, and returns a smurf.Comparison. Keyword arguments: `packages`, `args`, `xacro_env`. Raises smurf.Error
    when one cannot be read.
    """
def explain(rule: str) -> str:
    """The page of a rule, by its id or name: what, why, what to do."""


class _OneOfPlan:
    def known(self) -> Optional[bytes]: ...
    def check(self) -> Optional[Report]: ...
    def keep(self, answer: Union[str, bytes]) -> None: ...
    def digest(self) -> str: ...
    def size(self) -> Optional[Tuple[int, float]]: ...

class _EachPlan:
    def __len__(self) -> int: ...
    def path(self, index: int) -> str: ...
    def of(self, index: int) -> _OneOfPlan: ...
    def use_cache(self, folder: Path, form: str) -> None: ...
    def cache_problem(self) -> str: ...

def _plan_each(
    paths: Paths, *, config: Optional[Path] = ..., isolated: Optional[bool] = ...,
    select: Optional[Texts] = ..., ignore: Optional[Texts] = ...,
    severities: Optional[Dict[str, str]] = ..., targets: Optional[Texts] = ...,
    packages: Optional[Dict[str, Path]] = ..., args: Optional[Dict[str, Argument]] = ...,
    xacro_env: Optional[Texts] = ..., baseline: Optional[Path] = ...,
    no_ignores: Optional[bool] = ..., allow_outside: Optional[bool] = ..., max_seconds: Optional[int] = ...,
) -> _EachPlan: ...
