"""What looks: one network a camera, from an image to the positions of keypoints and on to features."""

from collections.abc import Mapping
from typing import Any

from optimus.learn.encoder.convolutions import EncoderConfig
from optimus.learn.encoder.keypoints import Encoder, SpatialSoftmax
from optimus.learn.encoder.resnet import ResNetConfig


def encoder_config(value: Mapping[str, Any]) -> EncoderConfig | ResNetConfig:
    """The inverse of `dataclasses.asdict`, from parsed JSON; an earlier version knew one kind only and did not name it."""
    kinds = {"convolutions": EncoderConfig.from_json, "resnet18": ResNetConfig.from_json}
    return kinds[value.get("kind", "convolutions")](value)


__all__ = ["Encoder", "EncoderConfig", "ResNetConfig", "SpatialSoftmax", "encoder_config"]
