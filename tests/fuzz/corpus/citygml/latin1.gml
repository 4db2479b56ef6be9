<?xml version='1.0' encoding='ISO-8859-15'?><c:CityModel xmlns:c='http://www.opengis.net/citygml/2.0' xmlns:b='http://www.opengis.net/citygml/building/2.0' xmlns:g='http://www.opengis.net/gml' xmlns:x='http://www.w3.org/1999/xlink'>
<c:cityObjectMember><b:Building g:id='b1'><g:name>Straße</g:name></b:Building></c:cityObjectMember>
</c:CityModel>