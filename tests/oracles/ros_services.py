"""Calls the parameter services of a node over Eclipse Cyclone DDS. Services have the topics and types of `rmw_fastrtps`."""

import argparse
import json
import time
from dataclasses import dataclass, field
from types import new_class

from ros_peer import Peer, qos

from cyclonedds.idl import IdlStruct
from cyclonedds.idl.annotations import final
from cyclonedds.idl.types import float64, int64, sequence, uint8, uint64
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

# Of rcl_interfaces/ParameterType.
TYPES = {1: "bool_value", 2: "integer_value", 3: "double_value", 4: "string_value", 9: "string_array_value"}


@final
@dataclass
class ParameterValue(IdlStruct, typename="rcl_interfaces::msg::dds_::ParameterValue_"):
    type: uint8 = 0
    bool_value: bool = False
    integer_value: int64 = 0
    double_value: float64 = 0.0
    string_value: str = ""
    byte_array_value: sequence[uint8] = field(default_factory=list)
    bool_array_value: sequence[bool] = field(default_factory=list)
    integer_array_value: sequence[int64] = field(default_factory=list)
    double_array_value: sequence[float64] = field(default_factory=list)
    string_array_value: sequence[str] = field(default_factory=list)


@final
@dataclass
class Parameter(IdlStruct, typename="rcl_interfaces::msg::dds_::Parameter_"):
    name: str = ""
    value: ParameterValue = field(default_factory=ParameterValue)


@final
@dataclass
class SetParametersResult(IdlStruct, typename="rcl_interfaces::msg::dds_::SetParametersResult_"):
    successful: bool = False
    reason: str = ""


@final
@dataclass
class FloatingPointRange(IdlStruct, typename="rcl_interfaces::msg::dds_::FloatingPointRange_"):
    from_value: float64 = 0.0
    to_value: float64 = 0.0
    step: float64 = 0.0


@final
@dataclass
class IntegerRange(IdlStruct, typename="rcl_interfaces::msg::dds_::IntegerRange_"):
    from_value: int64 = 0
    to_value: int64 = 0
    step: uint64 = 0


@final
@dataclass
class ParameterDescriptor(IdlStruct, typename="rcl_interfaces::msg::dds_::ParameterDescriptor_"):
    name: str = ""
    type: uint8 = 0
    description: str = ""
    additional_constraints: str = ""
    read_only: bool = False
    dynamic_typing: bool = False
    floating_point_range: sequence[FloatingPointRange] = field(default_factory=list)
    integer_range: sequence[IntegerRange] = field(default_factory=list)


@final
@dataclass
class ListParametersResult(IdlStruct, typename="rcl_interfaces::msg::dds_::ListParametersResult_"):
    names: sequence[str] = field(default_factory=list)
    prefixes: sequence[str] = field(default_factory=list)


def message(service: str, kind: str, **fields: type) -> type:
    """The request or the response of a service."""
    name = f"{service}_{kind}"
    options = {"typename": f"rcl_interfaces::srv::dds_::{name}_"}
    return final(dataclass(new_class(name, (IdlStruct,), options, lambda body: body.update(__annotations__=fields))))


SERVICES = {
    name: (message(service, "Request", **request), message(service, "Response", **response))
    for name, service, request, response in [
        ("get_parameters", "GetParameters", {"names": sequence[str]}, {"values": sequence[ParameterValue]}),
        ("get_parameter_types", "GetParameterTypes", {"names": sequence[str]}, {"types": sequence[uint8]}),
        (
            "list_parameters",
            "ListParameters",
            {"prefixes": sequence[str], "depth": uint64},
            {"result": ListParametersResult},
        ),
        ("describe_parameters", "DescribeParameters", {"names": sequence[str]}, {"descriptors": sequence[ParameterDescriptor]}),
        ("set_parameters", "SetParameters", {"parameters": sequence[Parameter]}, {"results": sequence[SetParametersResult]}),
        (
            "set_parameters_atomically",
            "SetParametersAtomically",
            {"parameters": sequence[Parameter]},
            {"result": SetParametersResult},
        ),
    ]
}


def value_of(plain: bool | int | float | str | list[str]) -> ParameterValue:
    """A parameter's value as a message."""
    kinds = {bool: 1, int: 2, float: 3, str: 4, list: 9}
    kind = kinds[type(plain)]
    return ParameterValue(type=kind, **{TYPES[kind]: plain})


def plain(answer: object) -> object:
    """An answer for JSON, with values of parameters as they are."""
    if isinstance(answer, ParameterValue):
        return plain(getattr(answer, TYPES[answer.type])) if answer.type else None
    if isinstance(answer, (list, tuple)):
        return [plain(one) for one in answer]
    if isinstance(answer, IdlStruct):
        return {name: plain(getattr(answer, name)) for name in answer.__dataclass_fields__}
    return answer


class Client:
    """A client of one service. Nobody else may call it meanwhile: answers are matched by their order."""

    def __init__(self, peer: Peer, node: str, service: str) -> None:
        self.request, response = SERVICES[service]
        participant = peer.participant
        topics = [
            Topic(participant, f"{prefix}{node}/{service}{suffix}", kind)
            for prefix, suffix, kind in [("rq", "Request", self.request), ("rr", "Reply", response)]
        ]
        self.writer = DataWriter(participant, topics[0], qos=qos(reliable=True))
        self.reader = DataReader(participant, topics[1], qos=qos(reliable=True, depth=10))

    def call(self, seconds: float = 40, **fields: object) -> object:
        end = time.monotonic() + seconds
        while not (self.writer.get_matched_subscriptions() and self.reader.get_matched_publications()):
            assert time.monotonic() < end, "no such service"
            time.sleep(0.01)
        while time.monotonic() < end:
            # The other side may have matched later, and then has lost the request; all requests may be repeated.
            self.writer.write(self.request(**fields))
            again = time.monotonic() + 3
            while time.monotonic() < again:
                for answer in self.reader.take(1):
                    return answer
                time.sleep(0.001)
        raise AssertionError("no answer")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("node")
    parser.add_argument("calls", nargs="+", help="a service and its request as JSON: a list of names, or values by name")
    arguments = parser.parse_args()
    peer, clients, answers = Peer(), {}, []
    for call in arguments.calls:
        service, _, request = call.partition(" ")
        given = json.loads(request or "[]")
        if service not in clients:
            clients[service] = Client(peer, arguments.node, service)
        if service == "list_parameters":
            fields = {"prefixes": given, "depth": 0}
        elif service.startswith("set"):
            fields = {"parameters": [Parameter(name, value_of(value)) for name, value in given.items()]}
        else:
            fields = {"names": given}
        before = time.time()
        answer = clients[service].call(**fields)
        (content,) = (getattr(answer, name) for name in answer.__dataclass_fields__)
        answers.append({"answer": plain(content), "called": before, "answered": time.time()})
    print(json.dumps(answers))


if __name__ == "__main__":
    main()
