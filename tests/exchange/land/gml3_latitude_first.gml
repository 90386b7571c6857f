<?xml version="1.0" encoding="UTF-8"?>
<gml:FeatureCollection xmlns:gml="http://www.opengis.net/gml/3.2" xmlns:f="http://example.org/farm">
 <gml:boundedBy><gml:Envelope srsName="urn:ogc:def:crs:EPSG::4326"><gml:lowerCorner>51.78 4.26</gml:lowerCorner><gml:upperCorner>51.782 4.264</gml:upperCorner></gml:Envelope></gml:boundedBy>
 <gml:featureMember><f:parcel gml:id="p1"><gml:name>north</gml:name><f:area_ha>6.15</f:area_ha>
  <f:geometry><gml:Polygon srsName="urn:ogc:def:crs:EPSG::4326"><gml:exterior><gml:LinearRing>
   <gml:posList srsDimension="2">51.780 4.260 51.780 4.264 51.782 4.264 51.782 4.260 51.780 4.260</gml:posList>
  </gml:LinearRing></gml:exterior></gml:Polygon></f:geometry></f:parcel></gml:featureMember>
 <gml:featureMember><f:parcel gml:id="p2"><gml:name>short form</gml:name>
  <f:geometry><gml:Polygon srsName="EPSG:4326"><gml:exterior><gml:LinearRing>
   <gml:posList>4.260 51.780 4.264 51.780 4.264 51.782 4.260 51.782 4.260 51.780</gml:posList>
  </gml:LinearRing></gml:exterior></gml:Polygon></f:geometry></f:parcel></gml:featureMember>
</gml:FeatureCollection>
